package org.maestro.sim.world;

import org.maestro.hal.sight.Paint;
import org.maestro.sim.parameters.CameraData;
import org.maestro.sim.parameters.ColourData;

/**
 * False matches of detection by colour: one thing taken for another (paper 5.2). In the light that
 * the camera is made for, things of one colour are told apart, since they were followed all the
 * time (assumed). Where a thing is over-lit it is lost: then whatever has the right colour may be
 * taken for it, and itself it may be taken for what its washed-out colour looks like.
 */
public record Likeness(CameraData camera, ColourData colour) {

  /** What happens less often than this is left out; assumed. */
  public static final double NEVER = 1e-6;

  /**
   * The chance that one frame shows something else as the wanted thing.
   *
   * @param wanted colour by which it is sought
   * @param wantedLux light upon the wanted thing; 0 when it is not in view
   * @param other colour of the other thing, in view
   * @param otherLux light upon that
   */
  public double mistaken(Paint wanted, double wantedLux, Paint other, double otherLux) {
    double lost = Math.max(camera.glare(wantedLux), camera.glare(otherLux));
    if (lost < NEVER) {
      return 0;
    }
    double away =
        wanted.distance(other.seenIn(otherLux, colour.saturationLux())) / colour.tolerance();
    return lost * camera.brightness(otherLux) * Math.exp(-away * away / 2);
  }
}
