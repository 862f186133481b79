package org.maestro.bench.tracking;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * What was foretold of where persons go next, and what they did: it was right if she comes there
 * within a minute. For one thread.
 */
final class Foretold {
  private static final Duration IN_TIME = Duration.ofMinutes(1);

  private final Map<String, Open> open = new TreeMap<>();
  private final Map<String, String> lastZone = new TreeMap<>();
  private final Calibration calibration = new Calibration();
  private final List<Double> leadSeconds = new ArrayList<>();
  private int moves;
  private int told;

  /** A prediction of which nobody knows yet whether it comes true. */
  private record Open(String to, double confidence, Duration at) {}

  /** Another evening begins: what is open is left out. */
  void begin() {
    told -= open.size();
    open.clear();
    lastZone.clear();
  }

  /**
   * How it is now.
   *
   * @param zone where the person truly is
   * @param isRoom whether it is one to stay in
   * @param heading where she is told to be heading
   * @param confidence how surely she is
   */
  void note(
      String person,
      String zone,
      boolean isRoom,
      Optional<String> heading,
      double confidence,
      Duration now) {
    String before = lastZone.put(person, zone);
    if (before != null && !before.equals(zone) && isRoom) {
      moves++;
    }
    Optional<Open> former = Optional.ofNullable(open.get(person));
    if (former.isPresent()) {
      judge(person, former.get(), zone, now);
    } else if (heading.isPresent() && !heading.get().equals(zone)) {
      open.put(person, new Open(heading.get(), confidence, now));
      told++;
    }
  }

  private void judge(String person, Open prediction, String zone, Duration now) {
    Duration passed = now.minus(prediction.at());
    boolean isLate = passed.compareTo(IN_TIME) > 0;
    boolean isSo = !isLate && prediction.to().equals(zone);
    if (isSo || isLate) {
      open.remove(person);
      calibration.add(prediction.confidence(), isSo);
    }
    if (isSo) {
      leadSeconds.add(passed.toMillis() / 1_000.0);
    }
  }

  /** Persons came into a room so often. */
  int moves() {
    return moves;
  }

  int told() {
    return told;
  }

  /** How long before the arrival it was told, of those that came true; seconds. */
  List<Double> leadSeconds() {
    return List.copyOf(leadSeconds);
  }

  Calibration calibration() {
    return calibration;
  }
}
