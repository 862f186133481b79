package org.maestro.random;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.hal.Position;
import org.maestro.sl.Formula;

/**
 * The states that can surely be brought about from one moment on, with the devices that can be used
 * then: for each thing every place where it could end (left, in a hand, beside another thing, in a
 * zone), for each robot every zone, for the lamps every combination of levels. "Surely" has two
 * sides: it is physically possible with something to spare, and what has to be found can be looked
 * at.
 */
final class Possibilities {

  /** The final place of a thing. */
  private record End(Kind kind, String where) {
    enum Kind {
      LEFT,
      HELD,
      BESIDE,
      WITHIN
    }
  }

  /** Surely next to each other, as far as sensors can tell. */
  private static final double NEAR_METRES = 0.4;

  /** Surely not next to each other. */
  private static final double APART_METRES = 0.8;

  private static final End LEFT = new End(End.Kind.LEFT, "");

  private final Site site;
  private final Moment moment;
  private final Set<String> usable;
  private final Lighting lighting;
  private final Map<String, FreeFloor> floors = new TreeMap<>();
  private final Set<String> openable = new TreeSet<>();

  /**
   * @param usable devices that have power and are on the bus
   */
  Possibilities(Site site, Moment moment, Set<String> usable) {
    this.site = site;
    this.moment = moment;
    this.usable = usable;
    this.lighting =
        new Lighting(
            site, moment, moment.levels().keySet().stream().filter(usable::contains).toList());
    for (String door : site.floor().doors()) {
      if (moment.openDoors().contains(door)
          || usable.contains(door) && !site.isTrue(door, "locked")) {
        openable.add(door);
      }
    }
    for (String robot : site.robots()) {
      if (usable.contains(robot)) {
        floors.put(robot, new FreeFloor(site, moment, robot, openable));
      }
    }
  }

  /**
   * @param goal spelled out
   */
  boolean canBe(Formula goal) {
    return SpelledOut.cases(goal).stream().anyMatch(this::canAllBe);
  }

  /** What is not to be is judged last: where a robot goes is settled by what is to be. */
  private boolean canAllBe(List<Formula> all) {
    List<Formula> parts = new ArrayList<>(all);
    parts.sort(Comparator.comparing(Formula.Not.class::isInstance));
    List<String> things = new ArrayList<>();
    for (String item : site.items()) {
      if (parts.stream().anyMatch(part -> speaksOf(part, item))) {
        things.add(item);
      }
    }
    return tryEnds(things, 0, new TreeMap<>(), parts);
  }

  private static boolean speaksOf(Formula part, String name) {
    Formula positive = part instanceof Formula.Not not ? not.operand() : part;
    return positive instanceof Formula.Atom atom
        && (Truths.name(atom.arguments(), 0).equals(name)
            || atom.arguments().size() > 1 && Truths.name(atom.arguments(), 1).equals(name));
  }

  private boolean tryEnds(
      List<String> things, int next, Map<String, End> ends, List<Formula> parts) {
    if (next == things.size()) {
      return holds(parts, ends);
    }
    String thing = things.get(next);
    for (End end : endsOf(thing)) {
      ends.put(thing, end);
      if (tryEnds(things, next + 1, ends, parts)) {
        return true;
      }
    }
    return false;
  }

  private List<End> endsOf(String item) {
    List<End> ends = new ArrayList<>();
    ends.add(LEFT);
    if (!isKnowable(item)) {
      return ends;
    }
    for (String robot : floors.keySet()) {
      if (canTake(robot, item)) {
        ends.add(new End(End.Kind.HELD, robot));
        for (String other : moment.places().keySet()) {
          if (!other.equals(item) && !site.robots().contains(other)) {
            ends.add(new End(End.Kind.BESIDE, other));
          }
        }
        site.floor().zones().forEach(zone -> ends.add(new End(End.Kind.WITHIN, zone)));
      }
    }
    return ends;
  }

  /** Whether somebody who looks finds it, or its holder says so. */
  private boolean isKnowable(String thing) {
    if (moment.isHidden(thing)) {
      return false;
    }
    Optional<String> holder = moment.holder(thing);
    if (holder.isPresent()) {
      return usable.contains(holder.get());
    }
    return moment.zone(thing).filter(this::canLook).isPresent();
  }

  /** Whether it is there, and does what it says. */
  boolean isUsable(String device) {
    return usable.contains(device);
  }

  /** Whether a camera looks there, in a light that there is or can be made. */
  boolean canLook(String zone) {
    return site.cameras().stream().anyMatch(camera -> canLook(camera, zone))
        && lighting.canMeet(fit(zone), site.floor().corners(zone));
  }

  private boolean canLook(String camera, String zone) {
    return usable.contains(camera) && site.floor().covers(camera, zone) && hasSensor(zone);
  }

  /** Whether a sensor that can be used stands where the light is compared. */
  boolean isMeasured(Formula comparison) {
    return hasSensor(Truths.Constraint.of((Formula.Comparison) comparison).subject());
  }

  private boolean hasSensor(String location) {
    return site.of("LightSensor").stream()
        .anyMatch(
            sensor ->
                usable.contains(sensor)
                    && site.pose(sensor).floor().equals(site.floor().location(location).floor()));
  }

  private static List<Truths.Constraint> fit(String zone) {
    return List.of(
        Truths.Constraint.light(zone, Site.CAMERA_LEAST_LUX, true),
        Truths.Constraint.light(zone, Site.CAMERA_GREATEST_LUX, false));
  }

  private FreeFloor floor(String robot) {
    return Objects.requireNonNull(floors.get(robot));
  }

  private boolean canTake(String robot, String item) {
    if (moment.holder(item).isPresent()) {
      return moment.holder(item).get().equals(robot);
    }
    return site.mass(item) <= site.payload(robot) && floor(robot).reaches(moment.place(item));
  }

  private boolean holds(List<Formula> parts, Map<String, End> ends) {
    Collection<String> holders =
        ends.values().stream().filter(e -> e.kind() == End.Kind.HELD).map(End::where).toList();
    if (new TreeSet<>(holders).size() < holders.size() || !areFeasible(ends)) {
      return false;
    }
    List<Truths.Constraint> light = new ArrayList<>();
    List<Position> seen = new ArrayList<>();
    Map<String, String> robotZones = new TreeMap<>();
    return parts.stream().allMatch(part -> holds(part, ends, light, seen, robotZones))
        && lighting.canMeet(light, seen);
  }

  private boolean areFeasible(Map<String, End> ends) {
    for (Map.Entry<String, End> entry : ends.entrySet()) {
      End end = entry.getValue();
      boolean feasible =
          switch (end.kind()) {
            case LEFT, HELD -> true;
            case WITHIN -> takers(entry.getKey()).stream().anyMatch(f -> f.reaches(end.where()));
            case BESIDE -> canEndBeside(entry.getKey(), end.where(), ends);
          };
      if (!feasible) {
        return false;
      }
    }
    return true;
  }

  private List<FreeFloor> takers(String item) {
    return floors.entrySet().stream()
        .filter(robot -> canTake(robot.getKey(), item))
        .map(Map.Entry::getValue)
        .toList();
  }

  private boolean canEndBeside(String item, String target, Map<String, End> ends) {
    End targetEnd = ends.getOrDefault(target, LEFT);
    if (targetEnd.kind() == End.Kind.WITHIN) {
      return takers(item).stream().anyMatch(floor -> floor.reaches(targetEnd.where()));
    }
    return targetEnd.kind() == End.Kind.LEFT
        && moment.holder(target).isEmpty()
        && isKnowable(target)
        && takers(item).stream()
            .anyMatch(floor -> floor.reachesBeside(moment.place(target), site.radius(target)));
  }

  private boolean holds(
      Formula part,
      Map<String, End> ends,
      List<Truths.Constraint> light,
      List<Position> seen,
      Map<String, String> robotZones) {
    if (part instanceof Formula.Comparison comparison) {
      Truths.Constraint constraint = Truths.Constraint.of(comparison);
      return (constraint.isOfLight()
              ? hasSensor(constraint.subject())
              : usable.contains(constraint.subject()))
          && light.add(constraint);
    }
    if (part instanceof Formula.Not not) {
      return isNot((Formula.Atom) not.operand(), ends, robotZones);
    }
    Formula.Atom atom = (Formula.Atom) part;
    String first = Truths.name(atom.arguments(), 0);
    String second = atom.arguments().size() > 1 ? Truths.name(atom.arguments(), 1) : "";
    return switch (atom.predicate()) {
      case "open" -> openable.contains(first);
      case "in" ->
          floors.containsKey(first)
              ? floors.get(first).reaches(second)
                  && second.equals(robotZones.merge(first, second, (a, b) -> a.equals(b) ? a : ""))
              : isIn(first, second, ends);
      case "nextTo" -> isNextTo(first, second, ends);
      case "canSee" -> isSeen(first, second, ends, light, seen);
      default -> throw new IllegalArgumentException("No judge of " + part);
    };
  }

  private boolean isNot(Formula.Atom atom, Map<String, End> ends, Map<String, String> robotZones) {
    String first = Truths.name(atom.arguments(), 0);
    String second = Truths.name(atom.arguments(), atom.arguments().size() - 1);
    return switch (atom.predicate()) {
      case "open" -> !moment.openDoors().contains(first);
      case "in" ->
          floors.containsKey(first)
              ? canGoElsewhere(first, second, robotZones)
              : isElsewhere(first, second, ends);
      case "nextTo" -> isApart(first, second, ends);
      default -> throw new IllegalArgumentException("No judge of not " + atom);
    };
  }

  private boolean canGoElsewhere(String robot, String place, Map<String, String> robotZones) {
    if (!robotZones.containsKey(robot)) {
      site.floor().zones().stream()
          .filter(zone -> !zone.equals(place) && floor(robot).reaches(zone))
          .findFirst()
          .ifPresent(zone -> robotZones.put(robot, zone));
    }
    String goesTo = robotZones.getOrDefault(robot, "");
    return !goesTo.isEmpty() && !goesTo.equals(place);
  }

  private boolean isElsewhere(String thing, String place, Map<String, End> ends) {
    End end = ends.getOrDefault(thing, LEFT);
    return switch (end.kind()) {
      case HELD, WITHIN -> !end.where().equals(place);
      case BESIDE -> false;
      case LEFT ->
          moment.places().containsKey(thing)
              && !floors.containsKey(thing)
              && isKnowable(thing)
              && !isThere(thing, place);
    };
  }

  private boolean isApart(String first, String second, Map<String, End> ends) {
    End one = ends.getOrDefault(first, LEFT);
    End other = ends.getOrDefault(second, LEFT);
    if (one.kind() == End.Kind.HELD || other.kind() == End.Kind.HELD) {
      return true;
    }
    return one.equals(LEFT)
        && other.equals(LEFT)
        && isKnowable(first)
        && isKnowable(second)
        && distance(first, second) > APART_METRES;
  }

  private double distance(String first, String second) {
    return moment.place(first).floor().distance(moment.place(second).floor());
  }

  private boolean isIn(String thing, String place, Map<String, End> ends) {
    End end = ends.get(thing);
    if (end == null) {
      return false;
    }
    return switch (end.kind()) {
      case HELD, WITHIN -> end.where().equals(place);
      case BESIDE -> false;
      case LEFT -> isKnowable(thing) && isThere(thing, place);
    };
  }

  private boolean isThere(String thing, String place) {
    return moment.holder(thing).isPresent()
        ? moment.holder(thing).get().equals(place)
        : moment.zone(thing).filter(place::equals).isPresent();
  }

  private boolean isNextTo(String first, String second, Map<String, End> ends) {
    End one = ends.getOrDefault(first, LEFT);
    End other = ends.getOrDefault(second, LEFT);
    return one.equals(new End(End.Kind.BESIDE, second))
        || other.equals(new End(End.Kind.BESIDE, first))
        || !first.equals(second)
            && one.equals(LEFT)
            && other.equals(LEFT)
            && moment.holder(first).isEmpty()
            && moment.holder(second).isEmpty()
            && isKnowable(first)
            && isKnowable(second)
            && distance(first, second) < NEAR_METRES;
  }

  private boolean isSeen(
      String camera,
      String thing,
      Map<String, End> ends,
      List<Truths.Constraint> light,
      List<Position> seen) {
    End end = ends.getOrDefault(thing, LEFT);
    Optional<String> zone =
        switch (end.kind()) {
          case WITHIN -> Optional.of(end.where());
          case LEFT ->
              isKnowable(thing) && moment.holder(thing).isEmpty()
                  ? moment.zone(thing)
                  : Optional.empty();
          case HELD, BESIDE -> Optional.empty();
        };
    boolean looked =
        zone.isPresent()
            && site.cameras().stream().anyMatch(c -> camera.equals(c) && canLook(c, zone.get()));
    if (looked) {
      light.addAll(fit(zone.get()));
      seen.addAll(site.floor().corners(zone.get()));
    }
    return looked;
  }
}
