package org.maestro.sim.world;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import org.maestro.hal.Photo;
import org.maestro.hal.Position;
import org.maestro.hal.sight.Lens;
import org.maestro.hal.sight.Paint;
import org.maestro.hal.sight.Size;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.floor.Segment;
import org.maestro.sim.image.Exposure;
import org.maestro.sim.image.LitFloor;
import org.maestro.sim.image.Picture;
import org.maestro.sim.image.Solid;
import org.maestro.sim.image.Solid.Shape;
import org.maestro.sim.image.Stage;
import org.maestro.sim.image.Wall;
import org.maestro.sim.parameters.PhysicalParameters;

/**
 * Takes pictures of the world as it is at a moment, in the light that falls upon each point. Things
 * are boxes of their size, persons a drum with a head, robots a base with a mast (assumed); they
 * throw shadows in the light of lamps, not in that of windows (assumed).
 */
public final class Photographer {

  private static final double WALL_METRES = 2.5;
  private static final Paint SKIN = new Paint(0.62, 0.42, 0.32);
  private static final Paint METAL = new Paint(0.14, 0.14, 0.15);
  private static final double HEAD_METRES = 0.11;
  private static final double MAST_METRES = 0.05;

  /** Of what is higher than this and no robot: a person; metres. */
  private static final double PERSON_METRES = 0.9;

  /** The robot's platform; KUKA youBot data sheet: 0.14 m. */
  private static final double PLATFORM_METRES = 0.14;

  /** Width of pictures for which a grid that is so many times coarser will do; assumed. */
  private static final int SMALL_PIXELS = 240;

  private static final int COARSER = 4;

  private final World world;
  private final Set<String> robots;
  private final PhysicalParameters parameters;

  /**
   * @param robots names of the bodies that drive on wheels
   */
  public Photographer(World world, Set<String> robots, PhysicalParameters parameters) {
    this.world = world;
    this.robots = robots;
    this.parameters = parameters;
  }

  /** Width and height in pixels. */
  public record Resolution(int width, int height) {

    /** The same shape, not wider than that. */
    public Resolution within(int widest) {
      return width <= widest
          ? this
          : new Resolution(widest, Math.max(1, (int) Math.round((double) height * widest / width)));
    }
  }

  /**
   * @param seed of the camera's noise; the same at the same moment gives the same picture
   */
  public Photo take(Pose pose, double viewDegrees, Resolution resolution, long seed, Duration now) {
    return light(lens(pose, viewDegrees, resolution), name -> true)
        .taken(31 * seed + now.toNanos());
  }

  public static Lens lens(Pose pose, double viewDegrees, Resolution resolution) {
    return new Lens(pose, viewDegrees, resolution.width(), resolution.height());
  }

  /**
   * The light in which pictures are taken now.
   *
   * @param shown of the bodies in the open or in a hand, those that are in it
   */
  public Picture light(Lens lens, Predicate<String> shown) {
    List<Solid> solids = new ArrayList<>();
    for (String name : world.bodies()) {
      if (!world.isHidden(name) && shown.test(name)) {
        addSolids(solids, name);
      }
    }
    Stage stage = new Stage(floor(solids, gridMetres(lens.width())), walls(), solids);
    return Picture.of(
        stage,
        lens,
        new Exposure(
            parameters.colour().saturationLux(),
            parameters.image().longestLux(),
            parameters.image().mostGain(),
            parameters.image().readNoise(),
            parameters.image().shotNoise()));
  }

  private void addSolids(List<Solid> solids, String name) {
    Position foot = world.position(name).orElseThrow();
    Size size = world.looks().size(name);
    Paint colour = world.looks().paint(name);
    double heading = world.whereabouts().heading(name);
    if (robots.contains(name)) {
      solids.add(solid(Shape.BOX, foot, 0, PLATFORM_METRES, size, heading, colour));
      solids.add(round(Shape.DRUM, foot, PLATFORM_METRES, size.height(), MAST_METRES, METAL));
    } else if (world.holder(name).isPresent()) {
      // in the hand, above the mast
      double hand = world.looks().size(world.holder(name).get()).height();
      solids.add(solid(Shape.BOX, foot, hand, hand + size.height(), size, heading, colour));
    } else if (size.height() >= PERSON_METRES) {
      double shoulders = size.height() - 2 * HEAD_METRES;
      solids.add(
          round(Shape.DRUM, foot, 0, shoulders, Math.min(size.length(), size.width()) / 2, colour));
      solids.add(round(Shape.BALL, foot, shoulders, size.height(), HEAD_METRES, SKIN));
    } else {
      solids.add(solid(Shape.BOX, foot, foot.z(), foot.z() + size.height(), size, heading, colour));
    }
  }

  private Solid solid(
      Shape shape,
      Position foot,
      double bottom,
      double top,
      Size size,
      double heading,
      Paint colour) {
    double lux = world.lux(new Position(foot.x(), foot.y(), top));
    return new Solid(
        shape,
        foot.x(),
        foot.y(),
        bottom,
        top,
        size.length() / 2,
        size.width() / 2,
        heading,
        colour,
        lux);
  }

  private Solid round(
      Shape shape, Position foot, double bottom, double top, double radius, Paint colour) {
    return solid(shape, foot, bottom, top, new Size(2 * radius, 2 * radius, top), 0, colour);
  }

  private List<Wall> walls() {
    List<Wall> walls = new ArrayList<>();
    for (Segment wall : world.building().walls()) {
      walls.add(
          new Wall(wall.from().x(), wall.from().y(), wall.to().x(), wall.to().y(), WALL_METRES));
    }
    return walls;
  }

  /**
   * A pixel of a small picture covers more of the floor, and there may be many of them a second.
   */
  private double gridMetres(int width) {
    double fine = parameters.image().gridMetres();
    return width <= SMALL_PIXELS ? COARSER * fine : fine;
  }

  private LitFloor floor(List<Solid> solids, double gridMetres) {
    double left = Double.POSITIVE_INFINITY;
    double lower = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    double upper = Double.NEGATIVE_INFINITY;
    for (Segment wall : world.building().walls()) {
      for (Point2 end : List.of(wall.from(), wall.to())) {
        left = Math.min(left, end.x());
        lower = Math.min(lower, end.y());
        right = Math.max(right, end.x());
        upper = Math.max(upper, end.y());
      }
    }
    return LitFloor.measured(
        left,
        lower,
        right,
        upper,
        gridMetres,
        (x, y) ->
            world
                .lighting()
                .luxInShadow(new Position(x, y, 0), lamp -> isInShadow(lamp, x, y, solids)));
  }

  /** Whether a solid stands between a lamp and a point of the floor. */
  private static boolean isInShadow(Pose lamp, double x, double y, List<Solid> solids) {
    for (Solid solid : solids) {
      // the shadow's ray is under the solid's top from here on
      double share = Math.max(0, Math.min(1, solid.top() / lamp.z()));
      double low = Math.max(0, Math.min(1, solid.bottom() / lamp.z()));
      Point2 from = new Point2(x + low * (lamp.x() - x), y + low * (lamp.y() - y));
      Point2 to = new Point2(x + share * (lamp.x() - x), y + share * (lamp.y() - y));
      double thick = solid.shape() == Shape.BOX ? solid.halfWidth() : solid.halfLength();
      if (new Segment(from, to).distance(new Point2(solid.x(), solid.y())) < thick) {
        return true;
      }
    }
    return false;
  }
}
