//! Functions without arguments are given the columns of the table that they stand over.

use datafusion::arrow::datatypes::DataType;
use datafusion::common::config::ConfigOptions;
use datafusion::common::tree_node::Transformed;
use datafusion::common::{Column, DFSchema, Result};
use datafusion::functions::core::named_struct;
use datafusion::logical_expr::expr::ScalarFunction;
use datafusion::logical_expr::expr_rewriter::FunctionRewrite;
use datafusion::logical_expr::{Expr, lit};
use kane_records::format::Format;
use kane_records::header::Header;
use kane_records::schema;
use kane_records::told::Told;

use crate::aggregate::Whole;
use crate::fault::LakeFault;
use crate::numbers::Numbers;

/// How the columns of a table are taken.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reading {
    /// names of the schema, and those of the table
    pub map: Vec<(String, String)>,
    /// the format of the numbers; without it columns of type float are `f32`, and others `f64`
    pub numbers: Option<Numbers>,
}

/// Gives `kane_…()` the struct of the columns that mean something, and the format of their numbers.
#[derive(Debug)]
pub(crate) struct FillIn(pub(crate) Reading);

impl FunctionRewrite for FillIn {
    fn name(&self) -> &str {
        "kane_columns"
    }

    fn rewrite(
        &self,
        expr: Expr,
        schema: &DFSchema,
        _: &ConfigOptions,
    ) -> Result<Transformed<Expr>> {
        match expr {
            Expr::ScalarFunction(mut call)
                if call.args.is_empty() && call.func.name().starts_with("kane_") =>
            {
                call.args = self.arguments(schema)?;
                Ok(Transformed::yes(Expr::ScalarFunction(call)))
            }
            Expr::AggregateFunction(mut call)
                if call.params.args.is_empty()
                    && Whole::ALL.iter().any(|whole| whole.function() == call.func.name()) =>
            {
                call.params.args = self.arguments(schema)?;
                Ok(Transformed::yes(Expr::AggregateFunction(call)))
            }
            other => Ok(Transformed::no(other)),
        }
    }
}

impl FillIn {
    fn arguments(&self, schema: &DFSchema) -> Result<Vec<Expr>, LakeFault> {
        let names: Vec<String> = schema.fields().iter().map(|field| field.name().clone()).collect();
        let header = Header::of(&names, &self.0.map)?;
        let mut pairs = Vec::new();
        let mut single = false;
        for (field, (table, column)) in header.fields.iter().zip(schema.iter()) {
            let Some(field) = field else { continue };
            pairs.push(lit(field.name()));
            pairs.push(Expr::Column(Column::from((table, column))));
            single |= is_velocity_after(*field) && *column.data_type() == DataType::Float32;
        }
        let told = if single { Format::Binary32 } else { Format::Binary64 };
        let numbers = self.0.numbers.unwrap_or(Numbers::new(Told::stated(told)));
        let rows = Expr::ScalarFunction(ScalarFunction::new_udf(named_struct(), pairs));
        Ok(vec![rows, lit(numbers.to_string())])
    }
}

/// Whether a column is one of those that tell the format.
fn is_velocity_after(field: schema::Field) -> bool {
    matches!(field, schema::Field::Number(schema::Column::Velocity(_, _, schema::When::Post)))
}
