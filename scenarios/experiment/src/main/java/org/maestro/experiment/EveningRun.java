package org.maestro.experiment;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.running.Ending;
import org.maestro.sl.Truth;

/**
 * An evening in one of the homes that are compared: what came of each goal.
 *
 * @param setUp the name of the home
 * @param wanted in the order of the wishes
 * @param seconds from its begin to the end of the last goal
 * @param wattHours that lamps, appliances of stated power and robots' batteries gave meanwhile
 * @param lux at the reference point of each zone, mean over the evening
 * @param pictures of its end; mostly none
 */
record EveningRun(
    int number,
    long seed,
    String setUp,
    List<Wanted> wanted,
    double seconds,
    double wattHours,
    Map<String, Double> lux,
    List<Figure> pictures) {
  EveningRun {
    wanted = List.copyOf(wanted);
    lux = Collections.unmodifiableMap(new TreeMap<>(lux));
    pictures = List.copyOf(pictures);
  }

  /** How a goal ended. */
  enum End {
    REACHED("reached"),
    /** The platform says so, and the world cannot tell: of a script, or of what is seen. */
    SAID_ONLY("said to be done, which the world cannot tell"),
    NOT_REACHED("says that it cannot be done"),
    FALSELY_CLAIMED("claims what is not so");

    private final String label;

    End(String label) {
      this.label = label;
    }

    String label() {
      return label;
    }
  }

  /**
   * What came of a goal.
   *
   * @param truth in the simulated world when it ended
   * @param seconds from when it was stated
   */
  record Wanted(Wish wish, Ending ending, Truth truth, double seconds) {
    End end() {
      return switch (truth) {
        case TRUE -> End.REACHED;
        case FALSE -> ending.claimed() ? End.FALSELY_CLAIMED : End.NOT_REACHED;
        case UNKNOWN -> ending.claimed() ? End.SAID_ONLY : End.NOT_REACHED;
      };
    }

    boolean isReached() {
      return end() == End.REACHED || end() == End.SAID_ONLY;
    }

    /** Why it is not so; empty when it is. */
    String failure() {
      return switch (end()) {
        case REACHED, SAID_ONLY -> "";
        case NOT_REACHED -> ending.explanation();
        case FALSELY_CLAIMED ->
            "The platform says that it is done, but in the simulated world it is not.";
      };
    }
  }

  long reached() {
    return wanted.stream().filter(Wanted::isReached).count();
  }
}
