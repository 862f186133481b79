package org.maestro.agents.negotiation;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.agents.content.AccountWords;
import org.maestro.agents.content.ArbitrationWords;
import org.maestro.agents.content.Orders;
import org.maestro.agents.content.ProposalReader;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.Conversations;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.HeldElsewhere;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.sl.Content;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;

/**
 * One order to one agent, from the contract to the report. An agent has to agree soon, and to
 * report within the step's time and a grace; one that does not is called off and reported as
 * failed. The order may be sent before the contract is settled only if there is none.
 */
public final class OrderUnderway implements ActionDispatcher.Handle {
  private static final Optional<String> NO_REASON = Optional.of("no reason given");

  private final MaestroAgent agent;
  private final Supplier<Optional<AID>> receiver;
  private final ActionDispatcher.Request order;
  private final Optional<String> client;
  private final ProtocolViolations misconduct;
  private Consumer<ActionDispatcher.Report> reported = report -> {};
  private Optional<String> conversation = Optional.empty();
  private Optional<AID> addressee = Optional.empty();
  private Optional<Duration> aliveAt = Optional.empty();
  private boolean agreed;
  private boolean held;
  private boolean unwanted;
  private boolean over;

  /**
   * @param receiver the agent as it is now; empty: the order is held back until it goes on
   */
  OrderUnderway(
      MaestroAgent agent,
      Supplier<Optional<AID>> receiver,
      ActionDispatcher.Request order,
      Optional<String> client,
      ProtocolViolations misconduct) {
    this.agent = agent;
    this.receiver = receiver;
    this.order = order;
    this.client = client;
    this.misconduct = misconduct;
  }

  void reportTo(Consumer<ActionDispatcher.Report> listener) {
    reported = listener;
  }

  /**
   * @param broken how the agent broke its contract; empty when it holds or there is none
   */
  void contractSettled(Optional<String> broken) {
    if (over) {
      return;
    }
    if (broken.isPresent()) {
      // Later, as the order may still be on its way to being noted by who gave it.
      agent.tell(() -> report(failed(broken.get(), List.of())));
    } else {
      send();
    }
  }

  /** In the same words each time, so that it is done once whoever hears it. */
  private void send() {
    Optional<AID> now = receiver.get();
    held = now.isEmpty();
    if (held) {
      return;
    }
    ACLMessage request =
        agent.message(
            ACLMessage.REQUEST,
            now.get(),
            Orders.order(order, agent.getLocalName(), now.get().getLocalName(), client));
    addressee = now;
    agreed = false;
    conversation =
        Optional.of(
            agent
                .conversations()
                .ask(
                    request,
                    agent.patience(agent.patience().agreement()),
                    this::answered,
                    this::late));
  }

  private void answered(ACLMessage reply) {
    if (Conversations.isOverdue(reply)) {
      overdue();
    } else if (reply.getPerformative() == ACLMessage.AGREE) {
      if (agreed) {
        note("agreed twice; ignored");
        return;
      }
      agreed = true;
      agent.conversations().extend(conversation.orElseThrow(), timeLimit());
    } else {
      if (reply.getPerformative() == ACLMessage.INFORM && !agreed) {
        note("reported " + feature() + " before it agreed to it; the report counts");
      }
      report(read(reply));
    }
  }

  /** The member is at it still. */
  void alive() {
    aliveAt = Optional.of(agent.clock().now());
    if (agreed) {
      conversation.ifPresent(id -> agent.conversations().extend(id, timeLimit()));
    }
  }

  @Override
  public Optional<Duration> aliveAt() {
    return aliveAt;
  }

  boolean isOf(String goalId, String feature) {
    return order.goalId().equals(goalId) && feature().equals(feature);
  }

  private Duration timeLimit() {
    Duration grace = order.step().feature().timing().grace().orElse(Duration.ZERO);
    return order.timeout().plus(grace).plus(agent.patience(agent.patience().report()));
  }

  private void overdue() {
    String what =
        agreed
            ? "agreed to "
                + feature()
                + " and did not report within "
                + Replies.seconds(timeLimit())
            : "did not take up "
                + feature()
                + " within "
                + Replies.seconds(agent.patience().agreement());
    note(what);
    callOff();
    report(failed(member() + " " + what, List.of()));
  }

  private void late(ACLMessage reply) {
    note(
        "sent "
            + ProposalReader.performative(reply)
            + " for "
            + feature()
            + " after that was over; ignored");
  }

  /** Whether nobody has it, because there may be somebody again soon. */
  boolean isHeld() {
    return held;
  }

  /** Who had it is no more; who takes over is asked for it again. */
  void agentMoves() {
    if (conversation.isPresent() && !over) {
      conversation.ifPresent(agent.conversations()::close);
      held = true;
    }
  }

  void goOn() {
    if (held && !over) {
      send();
      if (unwanted && !held) {
        callOff();
      }
    }
  }

  void agentEnded() {
    conversation.ifPresent(agent.conversations()::close);
    report(failed(member() + " has lost its agent while it was at " + feature(), List.of()));
  }

  private void note(String what) {
    misconduct.noted(order.goalId(), member() + " " + what);
  }

  private String member() {
    return order.step().member();
  }

  private String feature() {
    return order.step().feature().name();
  }

  private void report(ActionDispatcher.Report report) {
    if (!over) {
      over = true;
      reported.accept(report);
    }
  }

  /** A step that was not ordered yet reports its end at once, one under way when it has ended. */
  @Override
  public void cancel() {
    if (conversation.isPresent()) {
      unwanted = true;
      if (!held) {
        callOff();
      }
    } else {
      agent.tell(() -> report(failed("called off before it began", List.of())));
    }
  }

  private void callOff() {
    ACLMessage cancel =
        agent.message(
            ACLMessage.CANCEL,
            addressee.orElseThrow(),
            Words.content("cancel", Words.named("order", Words.text(conversation.orElseThrow()))));
    cancel.setConversationId(conversation.orElseThrow());
    agent.send(cancel);
  }

  /** The refusal of an order, or the failure of what was ordered. */
  private static ActionDispatcher.Report notDone(Words words) {
    Optional<String> problem =
        words.string("problem").or(() -> words.string("reason")).or(() -> NO_REASON);
    Optional<HeldElsewhere> other = ArbitrationWords.heldBy(words);
    return other.isPresent()
        ? ActionDispatcher.Report.held(other.get(), problem.orElseThrow())
        : new ActionDispatcher.Report(
            false,
            Map.of(),
            problem,
            refs(words),
            words.string("begun").filter("false"::equals).isEmpty(),
            Orders.refusal(words),
            words.string("unanswered").isPresent());
  }

  private ActionDispatcher.Report read(ACLMessage reply) {
    if (Replies.isFromPlatform(reply)) {
      return failed(member() + " has no agent any more to do " + feature(), List.of());
    }
    try {
      Words words =
          Words.parse(reply.getContent()).stream().findFirst().map(Words::of).orElseThrow();
      return switch (reply.getPerformative()) {
        case ACLMessage.INFORM ->
            new ActionDispatcher.Report(true, words.termsOf("outputs"), Optional.empty(), List.of())
                .with(AccountWords.account(words));
        case ACLMessage.FAILURE, ACLMessage.REFUSE -> notDone(words);
        default -> misunderstood(reply);
      };
    } catch (SlSyntaxException | NoSuchElementException e) {
      return reply.getPerformative() == ACLMessage.INFORM
          ? unreadable(reply)
          : misunderstood(reply);
    }
  }

  private ActionDispatcher.Report unreadable(ACLMessage reply) {
    String content = reply.getContent() == null ? "" : Replies.shortened(reply.getContent());
    String what = "reported " + feature() + " unreadably (" + content + ")";
    note(what);
    return failed(member() + " " + what, List.of());
  }

  private ActionDispatcher.Report misunderstood(ACLMessage reply) {
    String why = Replies.reason(reply).map(Replies::shortened).map(r -> ": " + r).orElse("");
    String what =
        "answered the order of " + feature() + " with " + ProposalReader.performative(reply) + why;
    note(what);
    return failed(member() + " " + what, List.of());
  }

  private static List<FeatureRun.Learnt> refs(Words words) {
    List<FeatureRun.Learnt> refs = new ArrayList<>();
    for (Content.Argument.Named ref : words.find("refs").map(Words::all).orElse(List.of())) {
      List<Term> terms = Words.of(ref).terms();
      if (terms.size() == 2 || terms.size() == 3) {
        Optional<String> need = terms.stream().skip(2).map(Words::plain).findFirst();
        refs.add(new FeatureRun.Learnt(Words.plain(terms.get(0)), terms.get(1), need));
      }
    }
    return refs;
  }

  public static ActionDispatcher.Report failed(String problem, List<FeatureRun.Learnt> refs) {
    return new ActionDispatcher.Report(false, Map.of(), Optional.of(problem), refs);
  }
}
