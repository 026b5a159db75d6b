//! A pyramid in place of the cone of friction: named along its diagonals, Coulomb's along its axes, and
//! out of the plane between them.

use std::fmt::Write as _;

use kane_impact::laws;
use kane_records::friction::{FrictionLaw, Pyramid};
use kane_records::reader::Kind;
use kane_records::study::{Options, Study, study};

/// Friction of a solver that takes the axes one by one, or of one that bounds their sum.
fn friction(pyramid: Pyramid, stop: [f64; 2], bound: f64) -> [f64; 2] {
    match pyramid {
        Pyramid::Outer => stop.map(|p| p.clamp(-bound, bound)),
        Pyramid::Inner => {
            let sum = stop[0].abs() + stop[1].abs();
            stop.map(|p| if sum > bound { p * bound / sum } else { p })
        }
    }
}

/// Spheres of radius 1 m that meet the ground with slips in these directions from the x axis, degrees.
fn log(pyramid: Pyramid, directions: &[f64]) -> String {
    let mut text = String::from(
        "mass,radius,inertia,mu,e,vx_pre,vy_pre,vz_pre,omega_x_pre,omega_y_pre,omega_z_pre,\
         vx_post,vy_post,vz_post,omega_x_post,omega_y_post,omega_z_post\n",
    );
    let (mu, inertia) = (0.3, 0.4);
    for degrees in directions {
        for (e, speed) in
            [(0.0, 0.5), (0.0, 3.0), (0.5, 0.5), (0.5, 2.0), (0.5, 4.0), (0.9, 1.0), (0.9, 5.0)]
        {
            let push = 1.0 + e;
            let (x, z) = (speed * degrees.to_radians().cos(), speed * degrees.to_radians().sin());
            // W = 1/m + r²/J = 3.5
            let [px, pz] = friction(pyramid, [-x / 3.5, -z / 3.5], mu * push);
            // ω = r × p/J, r = (0, −1, 0): r × p = (−p_z, 0, p_x)
            let _ = writeln!(
                text,
                "1,1,{inertia},{mu},{e},{x},-1,{z},0,0,0,{},{e},{},{},0,{}",
                x + px,
                z + pz,
                -pz / inertia,
                px / inertia
            );
        }
    }
    text
}

fn studied(log: &str) -> Study {
    study(log.as_bytes(), Kind::Csv, &Options::new(laws())).expect("it is a log")
}

#[test]
fn a_pyramid_is_named_by_what_it_has_along_its_diagonals() {
    for pyramid in [Pyramid::Outer, Pyramid::Inner] {
        let study = studied(&log(pyramid, &[45.0, 135.0, -45.0]));
        assert_eq!(study.rejections.total(), 0, "{:?}", study.rejections);
        let best = &study.friction[0];
        assert_eq!(best.law.pyramid(), Some(pyramid), "{best:?}");
        assert_eq!(best.consistent, best.rows);
    }
}

#[test]
fn along_its_axes_a_pyramid_is_the_cone() {
    for pyramid in [Pyramid::Outer, Pyramid::Inner] {
        let study = studied(&log(pyramid, &[0.0, 90.0, 180.0]));
        assert_eq!(study.rejections.total(), 0);
        assert_eq!(study.friction[0].law, FrictionLaw::Coulomb);
        assert_eq!(study.friction[0].law.pyramid(), None);
    }
}

#[test]
fn between_them_friction_leaves_the_plane_and_the_rows_are_rejected() {
    let study = studied(&log(Pyramid::Outer, &[20.0, 70.0]));
    // rows whose slip is stopped on both axes stay in the plane
    let slid = study.rejections.of_kind("leaves the plane");
    assert!(slid > 0 && slid == study.rejections.total(), "{:?}", study.rejections);
    assert_eq!(study.rows + slid, 14);
}

#[test]
fn another_share_is_no_pyramid() {
    for (share, pyramid) in [
        (0.7075, Some(Pyramid::Inner)),
        (1.4135, Some(Pyramid::Outer)),
        (0.72, None),
        (1.4, None),
        (0.5, None),
    ] {
        assert_eq!(FrictionLaw::Share(share).pyramid(), pyramid, "{share}");
    }
}
