#pragma once

namespace campuswalk::collision {

// libm's results differ in the last bit between machines, and a walk must not. These use only + - x / and
// sqrt; the error is below 1e-15 (a few times 2e-16) for angles up to some thousand turns.

struct SinCos {
    double sin = 0.0;
    double cos = 1.0;
};

/// Radians.
SinCos sin_cos(double angle);

/// The angle in (-pi, pi] of the direction (x, y), radians; 0 for the zero vector.
double angle_of(double y, double x);

/// The same direction in (-pi, pi], radians.
double wrapped_angle(double angle);

}  // namespace campuswalk::collision
