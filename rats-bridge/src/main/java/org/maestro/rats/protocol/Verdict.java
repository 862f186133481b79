package org.maestro.rats.protocol;

import java.util.List;

/**
 * A controller's verdict on what a member says of itself; retained.
 *
 * @param boot the life of the member that has said it
 * @param accepted whether it can be used as described
 * @param faults why not, each with its cure; at most {@link #MOST_FAULTS}, further ones are left
 *     away
 */
public record Verdict(String member, String boot, boolean accepted, List<Fault> faults) {

  /** So many are enough for a beginning, and fit into a message. */
  public static final int MOST_FAULTS = 50;

  public Verdict {
    faults = faults.stream().limit(MOST_FAULTS).toList();
  }

  /**
   * Something wrong in a description.
   *
   * @param line from 1; 0 when it has no lines to speak of
   * @param subject what is spoken of
   * @param property of it; empty when the fault is in the subject as a whole
   * @param problem what is wrong, read after subject and property
   * @param cure what would be right
   */
  public record Fault(int line, String subject, String property, String problem, String cure) {}
}
