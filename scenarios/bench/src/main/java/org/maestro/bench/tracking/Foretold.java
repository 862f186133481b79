package org.maestro.bench.tracking;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** What was foretold of where persons go next, and what they did. For one thread. */
final class Foretold {
  private final Map<String, Open> open = new TreeMap<>();
  private final Map<String, String> lastZone = new TreeMap<>();
  private final Calibration calibration = new Calibration();
  private final List<Double> leadSeconds = new ArrayList<>();
  private int moves;
  private int told;
  private int right;

  /** A prediction of which nobody knows yet whether it comes true. */
  private record Open(String from, String to, double confidence, Duration at) {}

  /**
   * How it is now.
   *
   * @param zone where the person truly is
   * @param heading where she is told to be heading, and how surely
   */
  void note(
      String person,
      String zone,
      Optional<String> heading,
      double confidence,
      Duration now,
      boolean isRoom) {
    String before = lastZone.put(person, zone);
    boolean moved = before != null && !before.equals(zone);
    if (moved && isRoom) {
      moves++;
    }
    Optional<Open> former = Optional.ofNullable(open.get(person));
    if (moved && former.isPresent() && !former.get().from().equals(zone)) {
      over(person, former.get(), zone, now);
    }
    Optional<Open> left = Optional.ofNullable(open.get(person));
    if (left.isPresent() && heading.isEmpty()) {
      over(person, left.get(), "", now);
    } else if (left.isEmpty() && heading.isPresent() && !heading.get().equals(zone)) {
      open.put(person, new Open(zone, heading.get(), confidence, now));
      told++;
    }
  }

  private void over(String person, Open prediction, String zone, Duration now) {
    open.remove(person);
    boolean isSo = prediction.to().equals(zone);
    calibration.add(prediction.confidence(), isSo);
    if (isSo) {
      right++;
      Duration lead = now.minus(prediction.at());
      leadSeconds.add(lead.toMillis() / 1_000.0);
    }
  }

  /** Persons came into a room so often. */
  int moves() {
    return moves;
  }

  int told() {
    return told;
  }

  int right() {
    return right;
  }

  /** How long before the arrival it was told, of those that came true; seconds. */
  List<Double> leadSeconds() {
    return List.copyOf(leadSeconds);
  }
}
