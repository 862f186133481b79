package org.maestro.rats.link;

import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Offer;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.Verdict;

/**
 * The controller's end of the bus. Any thread may call it; nothing blocks. Listeners are told on
 * the transport's thread (the clock's, when stepped) and must hand over at once.
 */
public interface RatsLink extends AutoCloseable {

  /** Its id as a caller: a member knows calls again only of the same caller. */
  String controller();

  /** Why there is no connection to the bus now; empty while there is one. */
  Optional<String> absence();

  /** Members whose status was ever seen on this site and not cleared, latest first known. */
  Collection<Member> members();

  /** Tells the listener of all members known now, then of each change. */
  void watch(MemberListener listener);

  /**
   * Tells the listener of one member, if it is known now, then of each change of that. Where there
   * are many members, who cares for one is not told of all.
   *
   * @return ends it; what was on its way may still be told
   */
  Runnable watch(String member, MemberListener listener);

  /**
   * Calls a member's feature; exactly one result follows, TIMED_OUT or FAILED with MEMBER_LOST at
   * the latest. A call that a former link of the same controller id has made already, in the same
   * words, is taken up again: the member answers what it has answered, or says how far it is;
   * nothing is done twice.
   */
  CallHandle call(Order order, CallListener listener);

  /**
   * Calls a member's feature in the life that it lives now, by an id of the link's own.
   *
   * @param parameters JSON values
   */
  default CallHandle call(
      String member,
      String feature,
      Map<String, Object> parameters,
      Duration timeout,
      Optional<String> task,
      CallListener listener) {
    return call(
        new Order(Optional.empty(), member, Optional.empty(), feature, parameters, timeout, task),
        listener);
  }

  /**
   * Ends a call that was made before, and of which nobody knows what became: it is not made again.
   * Exactly one result follows: the member's own word of the call, FAILED with CANCELED when the
   * member is at no such call, or that the member says nothing.
   *
   * @param order in the words of then
   */
  CallHandle end(Order order, CallListener listener);

  /**
   * Ends a call that a former link of the same controller id has made, and whose outcome nobody
   * waits for.
   *
   * @param boot the life of the member that was meant
   */
  void cancel(String member, String boot, String callId);

  /**
   * Asks the member for the price of parameter sets ({@code $cost}); one answer for each set, in
   * order.
   */
  void cost(
      String member,
      String feature,
      List<Map<String, Object>> parameterSets,
      Consumer<List<CostAnswer>> answer);

  /** Asks the member to tell once more who it is and what it says of itself. */
  void describe(String member);

  /**
   * The same.
   *
   * @param over is run once: the member has answered, or has not within the time
   */
  void describe(String member, Duration within, Runnable over);

  /**
   * Tells a member that what it says of itself is refused and why, or that it is right now; it need
   * not listen. That all is right from the beginning is not told.
   */
  void tell(Verdict verdict);

  /** Sends {@code $safe} to every member (Three-layered architecture, 3.2.1; M37). */
  void safe();

  /** Sends {@code $safe} to one member, whether or not it is there. */
  void safe(String member);

  @Override
  void close();

  /**
   * An order to a member to carry out a feature.
   *
   * @param id no other call of this controller may have it, now or before; empty: the link chooses
   * @param boot the life of the member that is meant, any other fails with RESTARTED; empty: the
   *     present one
   * @param parameters JSON values
   * @param timeout simulated time for queueing and execution
   * @param grace simulated time beyond that for the member to end it safely and to answer; absent:
   *     some seconds
   * @param task the goal it serves
   * @param expects what is counted on; whoever could do it for less may offer to
   */
  record Order(
      Optional<String> id,
      String member,
      Optional<String> boot,
      String feature,
      Map<String, Object> parameters,
      Duration timeout,
      Optional<Duration> grace,
      Optional<String> task,
      Optional<Call.Expectation> expects) {

    /** For which nobody is to offer anything. */
    public Order(
        Optional<String> id,
        String member,
        Optional<String> boot,
        String feature,
        Map<String, Object> parameters,
        Duration timeout,
        Optional<String> task) {
      this(
          id, member, boot, feature, parameters, timeout, Optional.empty(), task, Optional.empty());
    }
  }

  /**
   * A member as the link knows it.
   *
   * @param state the latest that was heard of this life
   * @param statesHeard how many of them were heard: the same one may be told again with other news
   */
  record Member(
      String id,
      MemberStatus.Phase phase,
      String boot,
      Optional<String> description,
      Optional<MemberState> state,
      long statesHeard) {}

  interface MemberListener {
    /** Status, description or state changed; a member is usable when READY and described. */
    void changed(Member member);

    /**
     * The member raises an alarm, and none of the calls that are open here is concerned: the one
     * that it names has ended, or is another's.
     */
    default void alerted(String member, String callId, String message) {}
  }

  interface CallListener {
    default void progressed(Progress progress) {}

    default void observed(Observation observation) {}

    /**
     * Another member could do it too (Three-layered architecture, 3.2.1; M43): whether it shall, is
     * up to who called.
     */
    default void offered(String member, Offer offer) {}

    /**
     * The member gives it back (Three-layered architecture, 3.2.1; M44); its outcome follows when
     * it is in a safe state.
     */
    default void released(String reason) {}

    void ended(Result result);
  }

  interface CallHandle {
    String callId();

    /** Sends {@code $cancel}; the result still comes through the listener. */
    void cancel();
  }
}
