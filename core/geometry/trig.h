#pragma once
// The few transcendental functions that scenes and views need. glibc's differ with the machine's
// instruction set (FMA variants are chosen at run time); ours give the same bytes everywhere.

namespace overstrike {

/// Sine and cosine of an angle in degrees, within one unit in the last place; exact (correctly
/// rounded, 0 and 1/2 and 1 exactly) at multiples of 30 and 45 degrees. Odd and even symmetry and
/// quarter turns hold bit for bit. NaN for an infinite angle.
double sin_deg(double degrees);
double cos_deg(double degrees);
/// cos_deg / sin_deg as (15) and (3) of NN74 need them: tan and cot within two units in the last
/// place.
double tan_deg(double degrees);
/// Arc tangent of y/x in degrees, -180..180, for building views from directions; within 4e-16
/// relative.
double atan2_deg(double y, double x);
/// Arc cosine in degrees, for chords (tessellation); within 1e-15 relative.
double acos_deg(double c);

/// (x, y) -> (x cosine + y sine, y cosine + x minus_sine): coordinates in a frame turned by the
/// angle. The sine's negative is a number of its own, since GCC 12 fuses x c + y s and y c - x s to
/// one multiply-add-and-subtract where the processor has it, whatever -ffp-contract says.
struct TurnBack {
  double cosine, sine, minus_sine;
  explicit TurnBack(double degrees)
      : cosine(cos_deg(degrees)), sine(sin_deg(degrees)), minus_sine(sin_deg(-degrees)) {}
};

}  // namespace overstrike
