package org.maestro.sim.image;

/** A point or direction in space; metres. */
record Vector(double x, double y, double z) {

  Vector plus(Vector other, double times) {
    return new Vector(x + times * other.x, y + times * other.y, z + times * other.z);
  }

  Vector cross(Vector other) {
    return new Vector(
        y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
  }
}
