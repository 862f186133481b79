package org.maestro.hal;

/**
 * The place of a face's eyes, and the direction in which they look straight ahead.
 *
 * @param heading counted from the x axis against the clock; degrees
 */
public record FaceMount(Position eyes, double heading) {

  /** The direction to a thing from here; what is where the eyes are is straight ahead. */
  public Gaze towards(String thing, Position at) {
    double x = at.x() - eyes.x();
    double y = at.y() - eyes.y();
    double flat = Math.hypot(x, y);
    double turn =
        flat == 0 ? 0 : Math.IEEEremainder(Math.toDegrees(Math.atan2(y, x)) - heading, 360);
    return new Gaze(thing, turn, Math.toDegrees(Math.atan2(at.z() - eyes.z(), flat)));
  }
}
