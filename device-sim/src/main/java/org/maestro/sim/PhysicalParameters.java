package org.maestro.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.maestro.hal.Position;
import org.maestro.ontology.home.Pose;

/**
 * Every number of the simulated physics, each with its source; "assumed" means stated here and
 * nowhere measured. Each can be given another value by its name ({@link PhysicalSettings}).
 *
 * @param shutters whether the shutters of a home are there; without them its windows stand free
 */
public record PhysicalParameters(
    boolean shutters,
    CameraData camera,
    ColourData colour,
    ImageData image,
    TurnData turn,
    SensorData sensor,
    FacadeData facade,
    LampData lamp,
    BaseData base,
    WheelData wheels,
    ArmData arm,
    BatteryData battery,
    DriveData drives) {

  public static PhysicalParameters standard() {
    return new PhysicalParameters(
        true,
        CameraData.LIFECAM,
        ColourData.USUAL,
        ImageData.USUAL,
        TurnData.YOUBOT,
        SensorData.TSL2561,
        FacadeData.USUAL,
        LampData.HUE,
        BaseData.YOUBOT,
        WheelData.YOUBOT,
        ArmData.YOUBOT,
        BatteryData.YOUBOT,
        DriveData.USUAL);
  }

  public PhysicalParameters with(CameraData other) {
    return new PhysicalParameters(
        shutters, other, colour, image, turn, sensor, facade, lamp, base, wheels, arm, battery,
        drives);
  }

  public PhysicalParameters with(SensorData other) {
    return new PhysicalParameters(
        shutters, camera, colour, image, turn, other, facade, lamp, base, wheels, arm, battery,
        drives);
  }

  public PhysicalParameters with(BaseData other) {
    return new PhysicalParameters(
        shutters, camera, colour, image, turn, sensor, facade, lamp, other, wheels, arm, battery,
        drives);
  }

  public PhysicalParameters with(ArmData other) {
    return new PhysicalParameters(
        shutters, camera, colour, image, turn, sensor, facade, lamp, base, wheels, other, battery,
        drives);
  }

  /** The same with other settings by name, such as {@code world.camera.noise} and {@code 0.05}. */
  public PhysicalParameters with(Map<String, String> settings) {
    return PhysicalSettings.apply(this, settings);
  }

  /**
   * @param frameRate frames a second, unless the home states it; paper 4.1: 30
   * @param width of an image, pixels, unless the home states it; paper 4.1: 1080p
   * @param height of an image, pixels
   * @param minimumLux paper 5.1: about 72 lux is the critical threshold
   * @param maximumLux assumed: colours wash out from 2,000 lux on
   * @param halfLux light in which half of the frames show an object; assumed a little under the
   *     threshold
   * @param slopeLux steepness of the logistic around it; assumed: at the threshold 98 % of the
   *     frames show it
   * @param washedOutSlopeLux the same around {@code maximumLux} times 1.1; assumed
   * @param noise of positions: standard deviation per metre of distance, each axis; assumed 1 %
   *     (calibration; a pixel is 2 mm at 2.8 m)
   * @param lightError standard deviation of the light estimated from images, relative; assumed
   * @param noticesGlare whether its software says nothing of images in which something is over-lit;
   *     assumed that it does. The paper's (5.2) did not: another thing was taken for the wanted one
   */
  public record CameraData(
      double frameRate,
      int width,
      int height,
      double minimumLux,
      double maximumLux,
      double halfLux,
      double slopeLux,
      double washedOutSlopeLux,
      double noise,
      double lightError,
      boolean noticesGlare) {
    static final CameraData LIFECAM =
        new CameraData(30, 1920, 1080, 72, 2000, 69, 0.75, 20, 0.01, 0.005, true);
    private static final double WASHED_OUT_HALF = 1.1;

    public CameraData {
      positive("camera.frameRate", frameRate);
      positive("camera.width", width);
      positive("camera.height", height);
      positive("camera.slopeLux", slopeLux);
      positive("camera.washedOutSlopeLux", washedOutSlopeLux);
    }

    CameraData atRate(double framesPerSecond) {
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
          noticesGlare);
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
          noticesGlare);
    }

    /** The chance that one frame shows a visible object in so much light in its colour. */
    double detectability(double lux) {
      return brightness(lux) * (1 - glare(lux));
    }

    /** The chance that there is enough light for one frame to show an object at all. */
    double brightness(double lux) {
      return 1 / (1 + Math.exp(-(lux - halfLux) / slopeLux));
    }

    /** The chance that there is so much that one frame shows it in a wrong colour. */
    double glare(double lux) {
      return 1 / (1 + Math.exp(-(lux - WASHED_OUT_HALF * maximumLux) / washedOutSlopeLux));
    }
  }

  /**
   * How colours look in an image. A channel of the image stands still where the light that a thing
   * throws back in it exceeds {@code saturationLux}.
   *
   * @param saturationLux light in which a wholly white thing is at the image's end; assumed: that
   *     from which colours wash out
   * @param tolerance distance in chromaticity (shares of red and green) at which one colour is
   *     taken for another in six frames of ten; assumed
   */
  public record ColourData(double saturationLux, double tolerance) {
    static final ColourData USUAL = new ColourData(2000, 0.1);

    public ColourData {
      positive("colour.saturationLux", saturationLux);
      positive("colour.tolerance", tolerance);
    }
  }

  /**
   * How pictures come out.
   *
   * @param longestLux with the longest exposure, a wholly white thing in so much light is at the
   *     image's end; assumed: a floor in 72 lux just becomes a middle grey
   * @param readNoise of a channel of a pixel, share of its end, standard deviation; assumed
   * @param shotNoise what comes on top at the end; assumed
   * @param gridMetres how finely the light upon the floor is measured for a picture
   */
  public record ImageData(
      double longestLux, double readNoise, double shotNoise, double gridMetres) {
    static final ImageData USUAL = new ImageData(170, 0.012, 0.02, 0.05);

    public ImageData {
      positive("image.longestLux", longestLux);
      positive("image.gridMetres", gridMetres);
    }
  }

  /**
   * How a camera on a robot looks around: from its mast, turning with the base.
   *
   * @param height of the lens; metres; assumed
   * @param downDegrees how far it is tilted down, so that it sees the floor beside its own base;
   *     assumed
   * @param overlap part of the angle of view that neighbouring views share; assumed
   * @param seconds for turning around once; youBot data sheet: about 90 degrees a second
   */
  public record TurnData(double height, double downDegrees, double overlap, double seconds) {
    static final TurnData YOUBOT = new TurnData(0.6, 35, 0.4, 4);
    private static final double FULL_CIRCLE = 360;

    /** The poses from which it looks, one after the other. */
    List<Pose> views(Position at, double viewDegrees) {
      int count = (int) Math.ceil(FULL_CIRCLE / (viewDegrees * (1 - overlap)));
      List<Pose> views = new ArrayList<>();
      for (int i = 0; i < count; i++) {
        views.add(new Pose(at.x(), at.y(), height, i * FULL_CIRCLE / count, -downDegrees, 0));
      }
      return views;
    }
  }

  /**
   * How a base rolls on its wheels.
   *
   * @param wheelRadius KUKA youBot: 0.0475 m; so are the following
   * @param halfLength half of 0.471 m between the axles
   * @param halfWidth half of 0.300 m between the wheels of an axle
   * @param turnSpeed youBot data sheet: 90 degrees a second
   * @param slip share of each wheel's turning that is lost, standard deviation around none; assumed
   * @param controlSeconds between two commands to the wheels; assumed
   * @param nearMetres so near to a corner of its way it counts as reached; assumed
   * @param aimRadians so well aimed, a base that turns first drives on; assumed
   */
  public record WheelData(
      double wheelRadius,
      double halfLength,
      double halfWidth,
      double turnSpeed,
      double slip,
      double controlSeconds,
      double nearMetres,
      double aimRadians) {
    static final WheelData YOUBOT =
        new WheelData(0.0475, 0.2355, 0.15, Math.PI / 2, 0.02, 0.1, 0.01, 0.05);
  }

  /**
   * @param leastLux TSL2561 data sheet: 0.1 lux; also its resolution here
   * @param greatestLux TSL2561 data sheet: 40,000 lux
   * @param integrationSeconds TSL2561 data sheet: nominal 402 ms
   * @param noise standard deviation, relative; assumed 1 %
   */
  public record SensorData(
      double leastLux, double greatestLux, double integrationSeconds, double noise) {
    static final SensorData TSL2561 = new SensorData(0.1, 40_000, 0.402, 0.01);

    /**
     * @param other standard deviation, relative
     */
    public SensorData withNoise(double other) {
      return new SensorData(leastLux, greatestLux, integrationSeconds, other);
    }
  }

  /**
   * The light sensor on the outside of a shutter's window: it tells what the sun sends straight
   * from what comes from all sides, as sunshine sensors do.
   *
   * @param everySeconds how often it measures; assumed
   * @param noise standard deviation, relative; assumed
   * @param worthTelling relative change from what was told last that is told; assumed
   */
  public record FacadeData(double everySeconds, double noise, double worthTelling) {
    static final FacadeData USUAL = new FacadeData(30, 0.02, 0.1);
  }

  /**
   * @param transitionSeconds Hue's usual transition time is 400 ms; the light jumps at its end
   *     (assumed)
   * @param whiteKelvin the white it starts with; assumed
   * @param whites the shades that the spots have; paper 4.1: four, these assumed from what Hue
   *     calls relax, read, concentrate and energize, within its 2,200 to 6,500 K
   */
  public record LampData(double transitionSeconds, int whiteKelvin, List<Integer> whites) {
    static final LampData HUE = new LampData(0.4, 2700, List.of(2200, 2700, 4000, 6500));

    public LampData {
      whites = List.copyOf(whites);
    }
  }

  /**
   * @param speed youBot data sheet: 0.8 m/s; reached at once (assumed)
   * @param radius youBot data sheet: 580 mm by 380 mm, the circle around it
   * @param power watts while driving; assumed from 24 V, 5 Ah and 90 minutes
   * @param checkSeconds how often the scanner looks for what came in the way; assumed
   */
  public record BaseData(double speed, double radius, double power, double checkSeconds) {
    static final BaseData YOUBOT = new BaseData(0.8, 0.347, 80, 0.25);

    public BaseData {
      positive("base.speed", speed);
      positive("base.checkSeconds", checkSeconds);
    }

    /** The same base at another speed; metres a second. */
    public BaseData atSpeed(double other) {
      return new BaseData(other, radius, power, checkSeconds);
    }
  }

  /**
   * @param reach from the base's middle; youBot data sheet: the arm reaches 0.655 m, minus its
   *     offset and the hand's angle (assumed)
   * @param payload youBot data sheet: 0.5 kg
   * @param extendSeconds assumed; so are the following durations
   * @param graspSeconds a jamming gripper's evacuation takes about a second (Brown et al. 2010),
   *     with pressing on
   * @param graspTolerance how far from where it is expected a thing is found by the camera on
   *     board; assumed
   * @param placingError standard deviation of where a thing comes to stand, each axis; assumed
   * @param power watts while moving; assumed
   */
  public record ArmData(
      double reach,
      double payload,
      double extendSeconds,
      double graspSeconds,
      double releaseSeconds,
      double foldSeconds,
      double graspTolerance,
      double placingError,
      double power) {
    static final ArmData YOUBOT = new ArmData(0.5, 0.5, 1.5, 1.5, 0.5, 1.0, 0.15, 0.01, 40);

    ArmData lifting(double other) {
      return new ArmData(
          reach,
          other,
          extendSeconds,
          graspSeconds,
          releaseSeconds,
          foldSeconds,
          graspTolerance,
          placingError,
          power);
    }

    /**
     * The same arm with another standard deviation of where things come to stand; metres, each
     * axis.
     */
    public ArmData withPlacingError(double other) {
      return new ArmData(
          reach,
          payload,
          extendSeconds,
          graspSeconds,
          releaseSeconds,
          foldSeconds,
          graspTolerance,
          other,
          power);
    }

    double pickSeconds() {
      return extendSeconds + graspSeconds + foldSeconds;
    }

    double placeSeconds() {
      return extendSeconds + releaseSeconds + foldSeconds;
    }
  }

  /**
   * What a robot's battery holds and what draws from it, beside base and arm while they move.
   *
   * @param wattHours KUKA youBot data sheet: 24 V, 5 Ah
   * @param idleWatts of computer, scanner and camera; assumed
   * @param worthTelling share of the charge after which it is told anew; assumed
   * @param checkSeconds how often it is looked at; assumed
   */
  public record BatteryData(
      double wattHours, double idleWatts, double worthTelling, double checkSeconds) {
    static final BatteryData YOUBOT = new BatteryData(120, 20, 0.05, 5);

    public BatteryData {
      positive("battery.wattHours", wattHours);
      positive("battery.worthTelling", worthTelling);
      positive("battery.checkSeconds", checkSeconds);
    }
  }

  private static void positive(String name, double value) {
    if (!(value > 0)) {
      throw new SimulationException("The setting world.%s is more than 0.".formatted(name));
    }
  }

  /**
   * @param doorSeconds to open or close; assumed
   * @param shutterSeconds for the whole way; assumed
   * @param relaySeconds until a switch has switched, over its radio; assumed
   */
  public record DriveData(double doorSeconds, double shutterSeconds, double relaySeconds) {
    static final DriveData USUAL = new DriveData(3, 8, 0.1);
  }
}
