package org.maestro.sim.parameters;

import org.maestro.sim.scene.SimulationException;

/**
 * The exposure, noise and resolution of pictures. The maker of the camera does not say which sensor
 * is in it: it is taken for one of those that are made for web cameras with 1080p.
 */
public record ImageData(
    @Quantity(
            meaning =
                "light in which, with the longest exposure and no gain, a wholly white thing is at the image's end",
            unit = "lux",
            source =
                "reckoned: AR0330 data sheet 2.0 V/(lux s); assumed: 1/30 s, f/2, nine tenths of the light through the lens, end at 1 V")
        double longestLux,
    @Quantity(
            meaning = "gain with which it goes on in less light",
            unit = "1",
            source = "AR0330 data sheet: analogue gain up to 8")
        double mostGain,
    @Quantity(
            meaning =
                "standard deviation of a channel of a pixel in the dark without gain, share of its end",
            unit = "1",
            source = "AR0330 data sheet: dynamic range 69.5 dB")
        double readNoise,
    @Quantity(
            meaning = "what comes on top of that at the end: the grain of light",
            unit = "1",
            source = "AR0330 data sheet: signal to noise at most 39 dB")
        double shotNoise,
    @Quantity(
            meaning = "how finely the light upon the floor is measured for a picture",
            unit = "m",
            source = "a matter of computing")
        double gridMetres) {
  static final ImageData USUAL = new ImageData(267, 8, 0.000335, 0.0112, 0.05);

  public ImageData {
    PhysicalParameters.positive("image.longestLux", longestLux);
    if (!(mostGain >= 1)) {
      throw new SimulationException("The setting world.image.mostGain is at least 1.");
    }
    PhysicalParameters.positive("image.gridMetres", gridMetres);
  }
}
