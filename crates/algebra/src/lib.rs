//! The clever, untrusted part: parsing, printing, rational functions, limits, signs.
