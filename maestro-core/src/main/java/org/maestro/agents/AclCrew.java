package org.maestro.agents;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.maestro.coordination.Crew;
import org.maestro.knowledge.FeatureRun;
import org.maestro.sl.Content;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;

/** Orders to the generic agents by FIPA request. */
final class AclCrew implements Crew {
  /** Wall time in which the agent reports a timeout that it has noticed itself. */
  private static final Duration GRACE = Duration.ofSeconds(10);

  private final MaestroAgent agent;
  private final Function<String, Optional<AID>> agentOf;

  AclCrew(MaestroAgent agent, Function<String, Optional<AID>> agentOf) {
    this.agent = agent;
    this.agentOf = agentOf;
  }

  @Override
  public Performance perform(Order order, Consumer<Report> reported) {
    String member = order.step().member();
    Optional<AID> receiver = agentOf.apply(member);
    if (receiver.isEmpty()) {
      agent.tell(() -> reported.accept(failed(member + " has no agent", List.of())));
      return () -> {};
    }
    ACLMessage request = agent.message(ACLMessage.REQUEST, receiver.get(), Orders.order(order));
    String conversation =
        agent
            .conversations()
            .ask(
                request,
                order.timeout().plus(agent.patience(GRACE)),
                reply -> {
                  if (reply.getPerformative() != ACLMessage.AGREE) {
                    reported.accept(report(reply));
                  }
                });
    return () ->
        agent.send(
            agent.message(
                ACLMessage.CANCEL,
                receiver.get(),
                Words.content("cancel", Words.named("order", Words.text(conversation)))));
  }

  @Override
  public void callOff(String member, Call call) {
    agentOf
        .apply(member)
        .ifPresent(
            receiver ->
                agent.send(agent.message(ACLMessage.CANCEL, receiver, Orders.callOff(call))));
  }

  private static Report report(ACLMessage reply) {
    try {
      Words words =
          Words.parse(reply.getContent()).stream().findFirst().map(Words::of).orElseThrow();
      if (reply.getPerformative() == ACLMessage.INFORM) {
        return new Report(true, words.termsOf("outputs"), Optional.empty(), List.of());
      }
      return failed(
          words.string("problem").or(() -> words.string("reason")).orElse("no reason given"),
          refs(words));
    } catch (SlSyntaxException | java.util.NoSuchElementException e) {
      return failed("an answer that cannot be read: " + reply.getContent(), List.of());
    }
  }

  private static List<FeatureRun.Learnt> refs(Words words) {
    List<FeatureRun.Learnt> refs = new ArrayList<>();
    for (Content.Argument.Named ref : words.find("refs").map(Words::all).orElse(List.of())) {
      List<Term> terms = Words.of(ref).terms();
      if (terms.size() == 2) {
        refs.add(new FeatureRun.Learnt(Words.plain(terms.get(0)), terms.get(1)));
      }
    }
    return refs;
  }

  private static Report failed(String problem, List<FeatureRun.Learnt> refs) {
    return new Report(false, Map.of(), Optional.of(problem), refs);
  }
}
