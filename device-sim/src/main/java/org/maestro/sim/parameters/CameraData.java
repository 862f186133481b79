package org.maestro.sim.parameters;

/**
 * The images that a camera takes, and the light in which its detection finds things by their
 * colour.
 */
public record CameraData(
    @Quantity(
            meaning = "images that it takes, unless the home states it",
            unit = "per s",
            source = "paper 4.1: 30")
        double frameRate,
    @Quantity(
            meaning = "width of an image, unless the home states it",
            unit = "pixels",
            source = "paper 4.1: 1080p")
        int width,
    @Quantity(meaning = "height of an image", unit = "pixels", source = "paper 4.1: 1080p")
        int height,
    @Quantity(
            meaning = "light at the reference point of an area from which things in it are found",
            unit = "lux",
            source = "paper 5.1: about 72 is the critical threshold")
        double minimumLux,
    @Quantity(meaning = "light above which colours wash out", unit = "lux", source = "assumed")
        double maximumLux,
    @Quantity(
            meaning = "light in which half of the frames show an object",
            unit = "lux",
            source = "assumed: a little under the threshold")
        double halfLux,
    @Quantity(
            meaning = "steepness of the logistic around that",
            unit = "lux",
            source = "assumed: at the threshold 98 % of the frames show it")
        double slopeLux,
    @Quantity(
            meaning = "the same around 1.1 times the light above which colours wash out",
            unit = "lux",
            source = "assumed")
        double washedOutSlopeLux,
    @Quantity(
            meaning = "standard deviation of a position on each axis, per metre of distance",
            unit = "m/m",
            source = "assumed: calibration; a pixel is 2 mm at 2.8 m")
        double noise,
    @Quantity(
            meaning = "standard deviation of the light estimated from images, relative",
            unit = "1",
            source = "assumed")
        double lightError,
    @Quantity(
            meaning =
                "whether its software says nothing of images in which something is over-lit; the paper's (5.2) did not: another thing was taken for the wanted one",
            unit = "true or false",
            source = "assumed that it does")
        boolean noticesGlare,
    @Quantity(
            meaning =
                "whether it finds things in the pictures that it takes, and not by the chances above: slow",
            unit = "true or false",
            source = "a condition, not a measure")
        boolean fromPixels,
    @Quantity(
            meaning = "width of the pictures in which it then finds them",
            unit = "pixels",
            source = "assumed: a third of 1080p")
        int detectionWidth) {
  public static final CameraData LIFECAM =
      new CameraData(30, 1920, 1080, 72, 2000, 69, 0.75, 20, 0.01, 0.005, true, false, 640);

  /**
   * Light in which half of the frames show a washed-out colour, by the light above which it does.
   */
  public static final double WASHED_OUT_HALF = 1.1;

  /** A camera that needs no light of the room has a light of its own. */
  private static final double LEAST_LUX = 0.01;

  public CameraData {
    PhysicalParameters.positive("camera.frameRate", frameRate);
    PhysicalParameters.positive("camera.width", width);
    PhysicalParameters.positive("camera.height", height);
    PhysicalParameters.positive("camera.detectionWidth", detectionWidth);
    PhysicalParameters.positive("camera.slopeLux", slopeLux);
    PhysicalParameters.positive("camera.washedOutSlopeLux", washedOutSlopeLux);
  }

  public CameraData atRate(double framesPerSecond) {
    return new CameraData(
        framesPerSecond,
        width,
        height,
        minimumLux,
        maximumLux,
        halfLux,
        slopeLux,
        washedOutSlopeLux,
        noise,
        lightError,
        noticesGlare,
        fromPixels,
        detectionWidth);
  }

  /**
   * The same camera for other light: its detection sets in as far below the least light, in its
   * proportion, as that of the usual one does.
   *
   * @param minimum above 0; so much is taken for 0
   */
  public CameraData within(double minimum, double maximum) {
    double scale = Math.max(LEAST_LUX, minimum) / minimumLux;
    return new CameraData(
        frameRate,
        width,
        height,
        minimum,
        maximum,
        halfLux * scale,
        slopeLux * scale,
        washedOutSlopeLux,
        noise,
        lightError,
        noticesGlare,
        fromPixels,
        detectionWidth);
  }

  /** One whose software takes images in which something is over-lit as it takes all others. */
  public CameraData trusting() {
    return new CameraData(
        frameRate,
        width,
        height,
        minimumLux,
        maximumLux,
        halfLux,
        slopeLux,
        washedOutSlopeLux,
        noise,
        lightError,
        false,
        fromPixels,
        detectionWidth);
  }

  /**
   * The same camera with other errors, both relative standard deviations.
   *
   * @param position per metre of distance
   * @param light of the light estimated from images
   */
  public CameraData withErrors(double position, double light) {
    return new CameraData(
        frameRate,
        width,
        height,
        minimumLux,
        maximumLux,
        halfLux,
        slopeLux,
        washedOutSlopeLux,
        position,
        light,
        noticesGlare,
        fromPixels,
        detectionWidth);
  }

  /** The chance that one frame shows a visible object in so much light in its colour. */
  public double detectability(double lux) {
    return brightness(lux) * (1 - glare(lux));
  }

  /** The chance that there is enough light for one frame to show an object at all. */
  public double brightness(double lux) {
    return 1 / (1 + Math.exp(-(lux - halfLux) / slopeLux));
  }

  /** The chance that there is so much that one frame shows it in a wrong colour. */
  public double glare(double lux) {
    return 1 / (1 + Math.exp(-(lux - WASHED_OUT_HALF * maximumLux) / washedOutSlopeLux));
  }
}
