package org.maestro.sim.drivers;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.maestro.hal.Photo;
import org.maestro.hal.Position;
import org.maestro.hal.Target;
import org.maestro.hal.sight.Appearance;
import org.maestro.hal.sight.Detector;
import org.maestro.hal.sight.Lens;
import org.maestro.hal.sight.Recollection;
import org.maestro.hal.sight.Sighting;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Pose;
import org.maestro.sim.image.Picture;
import org.maestro.sim.world.Looks;

/**
 * Detection in the pictures that the camera takes: what light, distance, a body in between and
 * noise leave of a thing is found, and nothing is known but the looks of things. Of what looks
 * alike its place tells which it is ({@link Recollection}).
 */
final class PictureDetection implements Detection {

  /** Sightings so near each other are of one thing; less than the things are apart. */
  private static final double ONE_THING_METRES = 0.1;

  /** Of fewer frames, or of fewer than half of the best one's, it may be noise. */
  private static final int AGREEING_FRAMES = 3;

  private final Actuator actuator;
  private final Eye eye;
  private final Detector detector;
  private final Darkroom darkroom;
  private final Map<String, Appearance> looks;
  private final Recollection recollection;

  /** Where pictures come from. */
  record Darkroom(Function<Pose, Lens> lens, Function<Lens, Picture> light) {}

  /**
   * @param looks of all things of the home, by name
   * @param recollection that of all cameras
   */
  PictureDetection(
      Actuator actuator,
      Eye eye,
      Detector detector,
      Darkroom darkroom,
      Map<String, Appearance> looks,
      Recollection recollection) {
    this.actuator = actuator;
    this.eye = eye;
    this.detector = detector;
    this.darkroom = darkroom;
    this.looks = Map.copyOf(looks);
    this.recollection = recollection;
  }

  @Override
  public Seen of(Target target, int frames) {
    Optional<Appearance> stated =
        Looks.stated(target.properties()).or(() -> Optional.ofNullable(looks.get(target.name())));
    if (stated.isEmpty()) {
      return Seen.doubtful(
          "It is not known what %s looks like: state its colour in the home."
              .formatted(target.name()));
    }
    if (!detector.hasColour(stated.get())) {
      return Seen.doubtful(
          "%s has no colour that tells it from floor and walls: this camera finds things by their colour."
              .formatted(target.name()));
    }
    return told(target.name(), stated.get(), frames);
  }

  private Seen told(String name, Appearance wanted, int frames) {
    Map<String, Appearance> others = new TreeMap<>(looks);
    others.remove(name);
    List<Take> takes =
        eye.views().get().stream()
            .map(darkroom.lens())
            .map(lens -> new Take(lens, darkroom.light().apply(lens)))
            .toList();
    List<Spot> spots = spots(takes, wanted, others.values(), frames);
    Set<String> alike =
        others.entrySet().stream()
            .filter(other -> detector.areAlike(wanted, other.getValue()))
            .map(Map.Entry::getKey)
            .collect(Collectors.toSet());
    Optional<Position> before = recollection.place(name);
    Recollection.Verdict verdict =
        recollection.judge(
            name,
            alike,
            spots.stream().map(Spot::place).toList(),
            place -> shows(takes, wanted, place, Detector.Place.FREE));
    Optional<String> doubt =
        verdict
            .doubt()
            .or(
                () ->
                    verdict.place().isEmpty()
                        ? hidden(name, before, takes, wanted)
                        : Optional.empty());
    return new Seen(
        verdict.place().map(place -> Math.min(frames, framesAt(place, spots))).orElse(0),
        verdict.place().map(this::astray),
        doubt);
  }

  /** Why it cannot be said that it is not there; empty when it can. */
  private Optional<String> hidden(
      String name, Optional<Position> before, List<Take> takes, Appearance wanted) {
    if (before.isPresent() && shows(takes, wanted, before.get(), Detector.Place.COVERED)) {
      return Optional.of(
          "Something stands where %s was seen last, and may hide it.".formatted(name));
    }
    boolean isTooSmall =
        takes.stream()
            .map(Take::lens)
            .allMatch(
                lens ->
                    lens.middle()
                        .filter(floor -> !detector.isLargeEnough(lens, wanted, floor))
                        .isPresent());
    return isTooSmall
        ? Optional.of(
            "%s is too small for this camera: its pictures hardly show it.".formatted(name))
        : Optional.empty();
  }

  /** One direction of a look. */
  private record Take(Lens lens, Picture picture) {}

  /** A defect of the device may shift all that it sees. */
  private Position astray(Position place) {
    Point2 seen = actuator.world().faults().astray(actuator.device()).from(place.floor());
    return new Position(seen.x(), seen.y(), place.z());
  }

  /** Whether walls let it see a place, and a picture shows that of it. */
  private boolean shows(List<Take> takes, Appearance wanted, Position place, Detector.Place what) {
    Point2 from = eye.views().get().get(0).floor();
    return !actuator.world().building().plan().isBlocked(from, place.floor())
        && takes.stream()
            .anyMatch(
                take ->
                    detector.place(
                            take.picture().taken(actuator.number()), take.lens(), wanted, place)
                        == what);
  }

  private static int framesAt(Position place, List<Spot> spots) {
    return spots.stream()
        .filter(spot -> spot.place().equals(place))
        .mapToInt(Spot::frames)
        .findFirst()
        .orElse(0);
  }

  /** What frames agree on. */
  private List<Spot> spots(
      List<Take> takes, Appearance wanted, Collection<Appearance> others, int frames) {
    List<Spot> spots = new ArrayList<>();
    for (Take take : takes) {
      for (int frame = 0; frame < frames; frame++) {
        Photo photo = take.picture().taken(actuator.number());
        for (Sighting seen : detector.find(photo, take.lens(), wanted, others)) {
          add(spots, seen.foot());
        }
      }
    }
    int most = spots.stream().mapToInt(Spot::frames).max().orElse(0);
    spots.removeIf(
        spot -> spot.frames() < Math.min(AGREEING_FRAMES, frames) || 2 * spot.frames() < most);
    return spots;
  }

  private static void add(List<Spot> spots, Position seen) {
    for (int i = 0; i < spots.size(); i++) {
      if (spots.get(i).place().distance(seen) <= ONE_THING_METRES) {
        spots.set(i, spots.get(i).with(seen));
        return;
      }
    }
    spots.add(new Spot(1, seen));
  }

  /**
   * Sightings of one thing.
   *
   * @param place mean of them
   */
  private record Spot(int frames, Position place) {
    Spot with(Position seen) {
      double share = 1.0 / (frames + 1);
      return new Spot(
          frames + 1,
          new Position(
              place.x() + share * (seen.x() - place.x()),
              place.y() + share * (seen.y() - place.y()),
              0));
    }
  }
}
