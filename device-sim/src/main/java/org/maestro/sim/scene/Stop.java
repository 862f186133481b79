package org.maestro.sim.scene;

import java.util.Arrays;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Pose;

/**
 * A corner of a round that a person walks.
 *
 * @param seconds how long she stays there, from 0 on
 */
public record Stop(Point2 place, double seconds) {
  private static final int WITH_TIME = 3;

  /**
   * Reads {@code x y}, or {@code x y seconds}.
   *
   * @throws IllegalArgumentException when it is something else
   */
  static Stop parse(String text) {
    String[] numbers = text.strip().split("\\s+");
    double seconds = 0;
    if (numbers.length == WITH_TIME) {
      seconds = Pose.numbers(numbers[WITH_TIME - 1])[0];
      if (seconds < 0) {
        throw new IllegalArgumentException(
            "Nobody stays for %s seconds.".formatted(numbers[WITH_TIME - 1]));
      }
      numbers = Arrays.copyOf(numbers, WITH_TIME - 1);
    }
    return new Stop(Pose.parse(String.join(" ", numbers) + " 0").floor(), seconds);
  }
}
