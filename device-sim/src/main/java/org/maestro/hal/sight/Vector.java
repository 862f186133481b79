package org.maestro.hal.sight;

/** A point or direction in space; metres. */
public record Vector(double x, double y, double z) {

  public Vector plus(Vector other, double times) {
    return new Vector(x + times * other.x, y + times * other.y, z + times * other.z);
  }

  Vector cross(Vector other) {
    return new Vector(
        y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
  }

  double dot(Vector other) {
    return x * other.x + y * other.y + z * other.z;
  }

  double length() {
    return Math.sqrt(dot(this));
  }
}
