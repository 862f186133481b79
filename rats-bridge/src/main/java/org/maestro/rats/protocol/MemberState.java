package org.maestro.rats.protocol;

import java.util.List;

/**
 * A member's report of itself: state, values and calls; retained.
 *
 * @param state z, the current abstract state
 * @param values facts in MAESTRO-SL: level, position, what it holds
 * @param running ids of the calls under way
 * @param queue ids of the calls that wait
 * @param disabled features that cannot run now
 * @param recent how the latest calls ended, the latest last: what they did is in the values; a
 *     member need not say so
 */
public record MemberState(
    String member,
    String boot,
    String state,
    List<String> values,
    List<String> running,
    List<String> queue,
    List<String> disabled,
    List<Ended> recent) {

  /** A call that is over. */
  public record Ended(String id, Outcome outcome) {}

  public MemberState(
      String member,
      String boot,
      String state,
      List<String> values,
      List<String> running,
      List<String> queue,
      List<String> disabled) {
    this(member, boot, state, values, running, queue, disabled, List.of());
  }

  /** The same with other values. */
  public MemberState with(List<String> otherValues) {
    return new MemberState(member, boot, state, otherValues, running, queue, disabled, recent);
  }

  /** Whether all is as in the other, though calls may have ended since that left no trace. */
  public boolean saysTheSameAs(MemberState other) {
    return withoutRecent().equals(other.withoutRecent());
  }

  private MemberState withoutRecent() {
    return new MemberState(member, boot, state, values, running, queue, disabled);
  }
}
