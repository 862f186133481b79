package org.maestro.console.members;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.maestro.agents.content.Words;
import org.maestro.console.questions.AclCalls;
import org.maestro.console.questions.RefusalException;
import org.maestro.rats.bounded.BoundedMap;
import org.maestro.sl.Term;

/**
 * Calls of members' features that people make by hand, by way of the members' agents. The latest
 * are kept. Any thread may use it.
 */
final class CallsByHand {
  private static final int MOST = 200;

  /** Beyond the call's own time, for its agent to say how it ended; wall time. */
  private static final Duration GRACE = Duration.ofSeconds(30);

  private final AclCalls orders;
  private final Function<String, Optional<String>> agentOf;
  private final double speed;

  // All are guarded by this.
  private final Map<String, CallByHand> calls = BoundedMap.ofNewest(MOST);
  private final Map<String, Runnable> ends = BoundedMap.ofNewest(MOST);
  private int latest;

  /**
   * @param agentOf the agent that stands for a member
   * @param speed simulated seconds in one of wall time
   */
  CallsByHand(AclCalls orders, Function<String, Optional<String>> agentOf, double speed) {
    this.orders = orders;
    this.agentOf = agentOf;
    this.speed = speed;
  }

  /**
   * Asks for it.
   *
   * @param person who has signed in, and for whom it is asked
   * @param timeout simulated time that it may take
   * @return completed as soon as the agent has agreed, or refused
   */
  CompletableFuture<JsonNode> begin(
      String member,
      String feature,
      Map<String, Term> parameters,
      Optional<String> person,
      Duration timeout) {
    Optional<String> agent = agentOf.apply(member);
    if (agent.isEmpty()) {
      return CompletableFuture.failedFuture(
          RefusalException.badInput(
              "No agent stands for %s; GET /agents lists those there are.".formatted(member)));
    }
    CallByHand call =
        new CallByHand(
            nextId(), member, feature, parameters, CallByHand.State.UNDER_WAY, Optional.empty());
    CompletableFuture<JsonNode> begun = new CompletableFuture<>();
    Duration patience = timeout.plus(Duration.ofMillis((long) (GRACE.toMillis() * speed)));
    Runnable end =
        orders.call(
            agent.get(),
            member,
            feature,
            parameters,
            person,
            timeout,
            patience,
            new Course(call, begun));
    synchronized (this) {
      ends.put(call.id(), end);
    }
    return begun;
  }

  /**
   * Ends a call that is under way; how it ended is told as of any other.
   *
   * @return why it cannot be; empty when it is being ended
   */
  synchronized Optional<String> end(String id) {
    CallByHand call = calls.get(id);
    if (call == null) {
      return Optional.of(unknown(id));
    }
    if (call.state() != CallByHand.State.UNDER_WAY) {
      return Optional.of("The call %s has ended already.".formatted(id));
    }
    Objects.requireNonNull(ends.get(id)).run();
    return Optional.empty();
  }

  /** That there is no such call, in a sentence. */
  static String unknown(String id) {
    return "There is no call %s, or not any more; the latest two hundred are kept.".formatted(id);
  }

  private synchronized String nextId() {
    return "M" + ++latest;
  }

  private synchronized void put(CallByHand call) {
    calls.put(call.id(), call);
  }

  /** What has become of one; empty when there was none, or not lately. */
  synchronized Optional<JsonNode> call(String id) {
    return Optional.ofNullable(calls.get(id)).map(CallByHand::document);
  }

  /** What becomes of one call. */
  private final class Course implements AclCalls.Listener {
    private final CallByHand call;
    private final CompletableFuture<JsonNode> begun;

    Course(CallByHand call, CompletableFuture<JsonNode> begun) {
      this.call = call;
      this.begun = begun;
    }

    @Override
    public void agreed() {
      put(call);
      begun.complete(call.document());
    }

    @Override
    public void refused(RefusalException because) {
      begun.completeExceptionally(because);
    }

    @Override
    public void done(Map<String, Term> outputs) {
      String told =
          outputs.entrySet().stream()
              .map(output -> output.getKey() + " " + Words.plain(output.getValue()))
              .collect(Collectors.joining(", "));
      put(call.ended(CallByHand.State.DONE, told.isEmpty() ? "done" : told));
    }

    @Override
    public void failed(String reason) {
      put(call.ended(CallByHand.State.FAILED, reason));
    }
  }
}
