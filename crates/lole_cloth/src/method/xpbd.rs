//! Small substeps with one projection of every constraint each: the real-time method.
