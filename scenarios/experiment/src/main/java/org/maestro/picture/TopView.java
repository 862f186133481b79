package org.maestro.picture;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.Area;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Polygon;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.floor.Segment;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Geometry;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.home.Windows;
import org.maestro.sim.world.World;
import org.maestro.sl.Term;

/**
 * A home and its simulated world from above: rooms by their light, doors, windows, shutters, camera
 * fields, lamps with their level, persons, things in their own colours and the robots' ways. It
 * draws by properties that geometry asks for, not by kinds of device.
 */
public final class TopView {
  private static final int WIDTH = 1600;
  private static final double BRIGHT_LUX = 100;
  private static final double MOVED_METRES = 0.3;

  /** What takes so much of the floor around it is drawn as somebody who stands or sits there. */
  private static final double STANDS_METRES = 0.15;

  private static final int CLEAR_OF_WALL = 70;

  private final Home home;
  private final World world;
  private final Geometry geometry;
  private final Scale scale;
  private final Map<String, Point2> firstPlaces = new TreeMap<>();

  public TopView(Home home, World world) {
    this.home = home;
    this.world = world;
    this.geometry = new Geometry(home);
    this.scale = Scale.of(outlines("Room").toList(), WIDTH);
    for (String name : world.bodies()) {
      world.position(name).ifPresent(place -> firstPlaces.put(name, place.floor()));
    }
  }

  /** Draws the world as it is now, with the ways since this view was made. */
  public void write(Path file) {
    BufferedImage image =
        new BufferedImage(WIDTH, scale.heightPixels(), BufferedImage.TYPE_INT_RGB);
    Graphics2D canvas = image.createGraphics();
    canvas.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    canvas.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    canvas.setColor(Color.WHITE);
    canvas.fillRect(0, 0, image.getWidth(), image.getHeight());
    Labels labels = new Labels(scale.floor());
    Legend legend = new Legend(scale);
    drawFloors(canvas, labels);
    legend.explain(Legend.Entry.FLOOR);
    drawFields(canvas);
    drawWalls(canvas, labels, legend);
    drawWays(canvas, labels);
    drawBodies(canvas, labels, legend);
    drawFixed(canvas, labels, legend);
    labels.draw(canvas);
    legend.draw(canvas, home.label());
    canvas.dispose();
    try {
      ImageIO.write(image, "png", file.toFile());
    } catch (IOException e) {
      throw new UncheckedIOException("The picture " + file + " cannot be written.", e);
    }
  }

  private void drawFloors(Graphics2D canvas, Labels labels) {
    for (Individual zone : ofClass("Zone")) {
      Polygon outline = geometry.outline(zone.name()).orElseThrow();
      double lux = world.lux(zone.name());
      canvas.setColor(Palette.floor(Math.min(1, lux / BRIGHT_LUX)));
      canvas.fill(scale.shape(outline));
      canvas.setStroke(Palette.dashed(2));
      canvas.setColor(Palette.ZONE);
      canvas.draw(scale.shape(outline));
      Point2D edge = scale.at(lowerEdge(outline));
      Point2D clear = new Point2D.Double(edge.getX(), edge.getY() - CLEAR_OF_WALL);
      labels.add(
          String.format(Locale.ROOT, "%s, %.0f lux", zone.name(), lux), clear, 0, Texts.NORMAL);
    }
  }

  /** The middle of the edge that is lowest in the picture. */
  private static Point2 lowerEdge(Polygon outline) {
    return outline.edges().stream()
        .map(Segment::middle)
        .min(Comparator.comparingDouble(Point2::y))
        .orElseThrow();
  }

  /** The floor that each camera sees: its cone, cut by its room's walls. */
  private void drawFields(Graphics2D canvas) {
    for (Device device : inOrder()) {
      Optional<Pose> pose = pose(device);
      Optional<Double> angle = number(device, "viewAngle");
      if (pose.isPresent() && angle.isPresent()) {
        double radius = pose.get().z() * Math.tan(Math.toRadians(angle.get() / 2));
        Area field = new Area(scale.circle(pose.get().floor(), radius));
        room(pose.get().floor()).ifPresent(room -> field.intersect(new Area(scale.shape(room))));
        canvas.setComposite(AlphaComposite.getInstance(AlphaComposite.SRC_OVER, 0.14f));
        canvas.setColor(Palette.CAMERA);
        canvas.fill(field);
        canvas.setComposite(AlphaComposite.SrcOver);
        canvas.setStroke(new BasicStroke(2.5f));
        canvas.draw(field);
      }
    }
  }

  private Optional<Polygon> room(Point2 point) {
    return outlines("Room").filter(outline -> outline.contains(point)).findFirst();
  }

  private void drawWalls(Graphics2D canvas, Labels labels, Legend legend) {
    canvas.setStroke(new BasicStroke(9, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    canvas.setColor(Palette.INK);
    outlines("Room").forEach(outline -> canvas.draw(scale.shape(outline)));
    outlines("Wall").forEach(outline -> canvas.fill(scale.shape(outline)));
    for (Individual individual : home.individuals().values()) {
      Geometry.opening(individual)
          .ifPresent(opening -> drawDoor(canvas, labels, individual, opening));
    }
    Windows windows = new Windows(home);
    for (Windows.Window window : windows.all().values()) {
      Openings.glass(canvas, scale, window.glass().base());
      legend.explain(Legend.Entry.WINDOW);
    }
    if (world.hasShutters()) {
      drawShutters(canvas, labels, windows, legend);
    }
  }

  private void drawShutters(Graphics2D canvas, Labels labels, Windows windows, Legend legend) {
    for (Device device : inOrder()) {
      for (Windows.Window window : windows.shadedBy(device.id())) {
        drawShutter(canvas, labels, device.id(), window.glass().base());
        legend.explain(Legend.Entry.SHUTTER);
      }
    }
  }

  private void drawShutter(Graphics2D canvas, Labels labels, String device, Segment glass) {
    double opening = world.opening(device);
    Openings.shutter(canvas, scale, glass, 1 - opening);
    labels.add(
        String.format(Locale.ROOT, "%s, %.0f %% open", device, opening * 100),
        scale.at(glass.middle()),
        Symbols.SMALL,
        Texts.SMALL);
  }

  private void drawDoor(Graphics2D canvas, Labels labels, Individual door, Segment opening) {
    Shape line = new Line2D.Double(scale.at(opening.from()), scale.at(opening.to()));
    boolean open = world.isOpen(door.name());
    canvas.setStroke(new BasicStroke(11, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER));
    canvas.setColor(open ? Color.WHITE : Palette.DOOR);
    canvas.draw(line);
    canvas.setStroke(new BasicStroke(3));
    canvas.setColor(Palette.DOOR);
    canvas.draw(line);
    labels.add(
        door.name() + (open ? ", open" : ", closed"),
        scale.at(opening.from()),
        Symbols.SMALL,
        Texts.SMALL);
  }

  private void drawWays(Graphics2D canvas, Labels labels) {
    for (Device device : inOrder()) {
      List<Point2D> way = world.path(device.id()).stream().map(p -> scale.at(p.point())).toList();
      if (way.size() > 1) {
        Way.draw(canvas, way);
        for (int i = 1; i < way.size(); i++) {
          labels.avoid(new Line2D.Double(way.get(i - 1), way.get(i)));
        }
        labels.add(device.id() + " at first", way.get(0), Symbols.SMALL, Texts.SMALL);
      }
    }
  }

  private void drawFixed(Graphics2D canvas, Labels labels, Legend legend) {
    for (Device device : inOrder()) {
      Optional<Pose> pose = pose(device);
      if (pose.isEmpty()) {
        continue;
      }
      Point2D at = scale.at(pose.get().floor());
      if (number(device, "luminousIntensity").isPresent()) {
        legend.explain(Legend.Entry.LAMP);
        Symbols.lamp(canvas, at, world.lampLevel(device.id()));
        String state =
            world.isAlive(device.id())
                ? String.format(Locale.ROOT, "%.0f %%", world.lampLevel(device.id()) * 100)
                : "dead";
        labels.add(device.id() + " " + state, at, Symbols.SMALL, Texts.SMALL);
      } else if (number(device, "viewAngle").isPresent()) {
        legend.explain(Legend.Entry.CAMERA);
        Symbols.camera(canvas, at);
        labels.add(device.id(), at, Symbols.SMALL, Texts.SMALL);
      } else {
        legend.explain(Legend.Entry.SENSOR);
        Symbols.sensor(canvas, at);
        labels.add(device.id(), at, Symbols.SMALL, Texts.SMALL);
      }
    }
  }

  private void drawBodies(Graphics2D canvas, Labels labels, Legend legend) {
    for (String name : world.bodies()) {
      Individual individual = home.individuals().get(name);
      Optional<Point2> place = world.position(name).map(position -> position.floor());
      if (individual == null || place.isEmpty() || world.holder(name).isPresent()) {
        continue;
      }
      Point2D at = scale.at(place.get());
      if (home.devices().containsKey(name)) {
        legend.explain(Legend.Entry.ROBOT);
        Symbols.robot(canvas, at);
        labels.add(
            name + world.held(name).map(held -> " with " + held).orElse(""),
            at,
            Symbols.LARGE,
            Texts.NORMAL);
      } else if (world.radius(name) >= STANDS_METRES) {
        legend.explain(Legend.Entry.PERSON);
        Symbols.person(canvas, at);
        labels.add(name, at, Symbols.LARGE, Texts.NORMAL);
      } else {
        drawFirstPlace(canvas, labels, name, place.get());
        legend.explain(Legend.Entry.THING);
        Symbols.thing(canvas, at, Palette.screen(world.paint(name)));
        labels.add(name, at, Symbols.SMALL, Texts.NORMAL);
      }
    }
  }

  private void drawFirstPlace(Graphics2D canvas, Labels labels, String name, Point2 now) {
    Point2 first = firstPlaces.getOrDefault(name, now);
    if (first.distance(now) > MOVED_METRES) {
      Point2D at = scale.at(first);
      Symbols.formerThing(canvas, at, Palette.screen(world.paint(name)));
      labels.add(name + " at first", at, Symbols.SMALL, Texts.SMALL);
    }
  }

  private List<Individual> ofClass(String name) {
    return home.individuals().values().stream()
        .filter(individual -> individual.classes().contains(name))
        .filter(individual -> geometry.outline(individual.name()).isPresent())
        .toList();
  }

  private Stream<Polygon> outlines(String className) {
    return ofClass(className).stream().map(i -> geometry.outline(i.name()).orElseThrow());
  }

  private List<Device> inOrder() {
    return home.devices().values().stream()
        .sorted(Comparator.comparingDouble(Device::order).thenComparing(Device::id))
        .toList();
  }

  private static Optional<Pose> pose(Device device) {
    return device.individual().properties().getOrDefault("pose", List.of()).stream()
        .filter(Term.Text.class::isInstance)
        .map(term -> Pose.parse(((Term.Text) term).value()))
        .findFirst();
  }

  private static Optional<Double> number(Device device, String property) {
    return device.individual().properties().getOrDefault(property, List.of()).stream()
        .filter(Term.Number.class::isInstance)
        .map(term -> ((Term.Number) term).value())
        .findFirst();
  }
}
