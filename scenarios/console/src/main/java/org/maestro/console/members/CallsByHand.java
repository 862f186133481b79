package org.maestro.console.members;

import com.fasterxml.jackson.databind.JsonNode;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import org.maestro.agents.DeskAgent;
import org.maestro.agents.content.Orders;
import org.maestro.agents.content.Words;
import org.maestro.console.questions.RefusalException;
import org.maestro.console.questions.Reply;
import org.maestro.coordination.api.Argument;
import org.maestro.rats.bounded.BoundedMap;
import org.maestro.sl.Content;
import org.maestro.sl.Term;

/**
 * Calls of members' features that people make by hand, by way of the members' agents, which judge
 * them as they judge any other. The latest are kept. Any thread may use it.
 */
final class CallsByHand {
  private static final int MOST = 200;

  /** Beyond the call's own time, for its agent to say how it ended. */
  private static final Duration GRACE = Duration.ofSeconds(30);

  private final DeskAgent desk;
  private final Function<String, Optional<String>> agentOf;
  private final double speed;

  // Both are guarded by this.
  private final Map<String, CallByHand> calls = BoundedMap.ofNewest(MOST);
  private int latest;

  /**
   * @param agentOf the agent that stands for a member
   * @param speed simulated seconds in one of wall time
   */
  CallsByHand(DeskAgent desk, Function<String, Optional<String>> agentOf, double speed) {
    this.desk = desk;
    this.agentOf = agentOf;
    this.speed = speed;
  }

  /**
   * Asks for it.
   *
   * @param timeout simulated time that it may take
   * @return completed as soon as the agent has agreed, or refused
   */
  CompletableFuture<JsonNode> begin(
      String member, String feature, Map<String, Term> parameters, Duration timeout) {
    Optional<String> agent = agentOf.apply(member);
    if (agent.isEmpty()) {
      return CompletableFuture.failedFuture(
          RefusalException.badInput(
              "No agent stands for %s; GET /agents lists those there are.".formatted(member)));
    }
    CompletableFuture<JsonNode> begun = new CompletableFuture<>();
    String id = nextId();
    desk.request(
        ACLMessage.REQUEST,
        agent.get(),
        timeout.plus(Duration.ofMillis((long) (GRACE.toMillis() * speed))),
        reply -> heard(id, member, feature, parameters, reply, begun),
        order(member, agent.get(), feature, parameters, timeout));
    return begun;
  }

  private synchronized String nextId() {
    return "M" + ++latest;
  }

  private static Content order(
      String member, String agent, String feature, Map<String, Term> parameters, Duration timeout) {
    Map<String, Argument> named = new TreeMap<>();
    parameters.forEach(
        (name, value) -> named.put(name, new Argument(value, Optional.empty(), Map.of())));
    List<Content.Argument> arguments = new ArrayList<>(Orders.member(member, agent));
    arguments.add(Words.named("feature", Words.name(feature)));
    arguments.add(Words.named("timeout", Words.number((double) timeout.toMillis())));
    arguments.add(Orders.parameters("parameters", named));
    return new Content("perform", arguments);
  }

  private void heard(
      String id,
      String member,
      String feature,
      Map<String, Term> parameters,
      ACLMessage reply,
      CompletableFuture<JsonNode> begun) {
    CallByHand underWay =
        new CallByHand(
            id, member, feature, parameters, CallByHand.State.UNDER_WAY, Optional.empty());
    if (reply.getPerformative() == ACLMessage.AGREE) {
      put(underWay);
      begun.complete(underWay.document());
    } else if (DeskAgent.isEnd(reply)) {
      List<Words> words = Reply.words(reply);
      if (reply.getPerformative() == ACLMessage.INFORM) {
        put(underWay.ended(CallByHand.State.DONE, outputs(words)));
      } else if (find(id).isPresent()) {
        put(underWay.ended(CallByHand.State.FAILED, Reply.reason(words)));
      } else {
        begun.completeExceptionally(
            reply.getPerformative() == ACLMessage.FAILURE
                ? RefusalException.outside(Reply.reason(words))
                : Reply.refusal(words));
      }
    }
  }

  private static String outputs(List<Words> words) {
    StringBuilder told = new StringBuilder();
    for (Words line : words) {
      line.termsOf("outputs")
          .forEach(
              (name, value) ->
                  told.append(told.isEmpty() ? "" : ", ")
                      .append(name)
                      .append(' ')
                      .append(Words.plain(value)));
    }
    return told.isEmpty() ? "done" : told.toString();
  }

  private synchronized void put(CallByHand call) {
    calls.put(call.id(), call);
  }

  private synchronized Optional<CallByHand> find(String id) {
    return Optional.ofNullable(calls.get(id));
  }

  /** What has become of one; empty when there was none, or not lately. */
  Optional<JsonNode> call(String id) {
    return find(id).map(CallByHand::document);
  }
}
