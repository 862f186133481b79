package org.maestro.agents.calls;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import org.maestro.agents.content.AccountWords;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.ArbitrationWords;
import org.maestro.agents.content.Orders;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.negotiation.OrderUnderway;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.HeldElsewhere;
import org.maestro.members.CallReporter;
import org.maestro.members.MemberNews;
import org.maestro.members.MemberOrders;
import org.maestro.members.MemberView;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.rats.bounded.BoundedMap;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.Offer;
import org.maestro.rats.protocol.Outcome;
import org.maestro.sl.Content;
import org.maestro.sl.Term;

/**
 * The requests to a generic agent's member to act: carried out as calls over the bus, and reported
 * in messages to who asked. Agent thread only.
 */
public final class ActionExecution {
  private static final int MOST_RECENT = 256;

  private final MaestroAgent agent;
  private final String member;
  private final RatsLink link;
  private final MemberView view;
  private final MemberNews news;
  private final MemberOrders orders;
  private final FormerCalls formerCalls;
  private final Arbitration arbitration;
  private final Map<String, RatsLink.CallHandle> handles = new TreeMap<>();
  private final Map<String, Runnable> abandoned = new TreeMap<>();

  /** Of calls, also for some time after their end. */
  private final Map<String, String> recentGoals = BoundedMap.ofNewest(MOST_RECENT);

  /**
   * @param formerCalls what is known of calls before the agent came here
   * @param arbitration who may use what of the member
   */
  public ActionExecution(
      MaestroAgent agent,
      String member,
      RatsLink link,
      MemberView view,
      MemberNews news,
      MemberOrders orders,
      FormerCalls formerCalls,
      Arbitration arbitration) {
    this.agent = agent;
    this.member = member;
    this.link = link;
    this.view = view;
    this.news = news;
    this.orders = orders;
    this.formerCalls = formerCalls;
    this.arbitration = arbitration;
  }

  /** A call is known again only in the same life of the member, from the same caller. */
  public String life() {
    return news.boot() + "@" + link.controller();
  }

  /** The member's life in which it is called. */
  Optional<String> boot() {
    return Optional.of(news.boot());
  }

  public void perform(ACLMessage message, Words words) {
    if (agent.isCutOff()) {
      agent.reply(
          message,
          ACLMessage.FAILURE,
          Words.content(
              "inform",
              Words.named("outcome", Words.name("rejected")),
              Words.named("begun", Words.name("false")),
              Words.named(
                  "problem",
                  Words.text(
                      "the agent of "
                          + member
                          + " was cut off from the platform, and begins nothing any more"))));
      return;
    }
    String name = words.string("feature").orElse("");
    Optional<FeatureType> feature = view.feature(name);
    if (!view.isReady() || feature.isEmpty()) {
      agent.refuse(
          message, ACLMessage.REFUSE, view.isReady() ? unknown(name) : member + " is not there");
      return;
    }
    if (!isOfThisLife(words)) {
      agent.refuse(message, ACLMessage.REFUSE, member + " was started again since it was asked");
      return;
    }
    Optional<HeldElsewhere> other = heldElsewhere(message, words, feature.get());
    if (other.isPresent()) {
      agent.reply(message, ACLMessage.REFUSE, ArbitrationWords.held(other.get(), member));
      return;
    }
    Map<String, Argument> arguments =
        words.find("parameters").map(Orders::arguments).orElse(Map.of());
    if (words.string("goal").isEmpty() && Pointers.areMissing(feature.get(), arguments)) {
      new Pointers(agent, member)
          .complete(
              feature.get(),
              arguments,
              complete -> agreed(message, words, feature.get(), complete),
              problem -> agent.refuse(message, ACLMessage.REFUSE, problem));
    } else {
      agreed(message, words, feature.get(), arguments);
    }
  }

  /** Who orders something for no goal, by hand, asks nobody. */
  private Optional<HeldElsewhere> heldElsewhere(
      ACLMessage message, Words words, FeatureType feature) {
    return words
        .string("goal")
        .filter(goal -> words.string("ends").isEmpty())
        .flatMap(goal -> arbitration.use(message.getSender(), goal, feature));
  }

  private boolean isOfThisLife(Words words) {
    String life = words.string("life").orElse(life());
    return life.equals(life())
        || words.string("call").filter(c -> formerCalls.mayBegin(life, news.boot(), c)).isPresent();
  }

  private void agreed(
      ACLMessage message, Words words, FeatureType feature, Map<String, Argument> arguments) {
    agent.reply(
        message,
        ACLMessage.AGREE,
        Words.content("perform", Words.named("feature", Words.name(feature.name()))));
    MemberOrders.Order order =
        new MemberOrders.Order(
            feature,
            arguments,
            Duration.ofMillis((long) words.number("timeout", 30_000)),
            words.string("call"),
            boot(),
            words.string("goal"),
            expected(words),
            words.string("ends").isPresent());
    String conversation = conversation(message);
    abandoned.put(
        conversation,
        () ->
            answer(
                message,
                Outcome.FAILED,
                OrderUnderway.failed(
                    "the agent of " + member + " was moved while it was at it", List.of())));
    if (words.string("watch").isPresent() && feature.continuous()) {
      handles.put(conversation, orders.begin(order, new Watched(message, conversation)));
      return;
    }
    begin(
        conversation,
        order,
        Optional.of(message.getSender()),
        (outcome, report) -> answer(message, outcome, report));
  }

  /**
   * A call of which each observation is told to who ordered it, and to nobody else, until it is
   * over.
   */
  private final class Watched implements CallReporter.Listener {
    private final ACLMessage message;
    private final String conversation;
    private boolean isEstablished;

    Watched(ACLMessage message, String conversation) {
      this.message = message;
      this.conversation = conversation;
    }

    @Override
    public void reported(Outcome outcome, ActionDispatcher.Report report) {
      isEstablished = report.succeeded();
      if (isEstablished) {
        learnt(report.outputs());
      } else {
        answer(message, outcome, report);
      }
    }

    @Override
    public void learnt(Map<String, Term> outputs) {
      agent.reply(
          message, ACLMessage.CONFIRM, Words.content("inform", Words.terms("outputs", outputs)));
    }

    @Override
    public void over() {
      handles.remove(conversation);
      if (abandoned.remove(conversation) != null && isEstablished) {
        agent.refuse(message, ACLMessage.FAILURE, member + " has ended it");
      }
    }
  }

  /** What who orders it counts on. */
  private static Optional<Call.Expectation> expected(Words words) {
    double cost = words.number("cost", -1);
    double seconds = words.number("seconds", -1);
    return cost < 0 || seconds < 0
        ? Optional.empty()
        : Optional.of(new Call.Expectation(cost, seconds));
  }

  /**
   * The agent leaves without waiting: what runs is called off, and reported as failed to who
   * ordered it.
   */
  public void abandon() {
    Map.copyOf(handles).values().forEach(RatsLink.CallHandle::cancel);
    List.copyOf(abandoned.values()).forEach(Runnable::run);
    abandoned.clear();
    handles.clear();
  }

  /** Whether the member does anything that this agent is to report. */
  public boolean isIdle() {
    return handles.isEmpty();
  }

  /**
   * Has the member do it.
   *
   * @param conversation names it here
   * @param holder of the contract, who hears of offers to do it better, and when it is given back
   * @param reported told once
   */
  RatsLink.CallHandle begin(
      String conversation,
      MemberOrders.Order order,
      Optional<AID> holder,
      BiConsumer<Outcome, ActionDispatcher.Report> reported) {
    order.call().ifPresent(formerCalls::begun);
    RatsLink.CallHandle handle =
        orders.begin(order, new Reporter(conversation, order, holder, reported));
    handles.put(conversation, handle);
    order.goal().ifPresent(goal -> recentGoals.put(handle.callId(), goal));
    return handle;
  }

  private String unknown(String name) {
    return name.isEmpty()
        ? "An order names a feature, such as (perform (:feature "
            + view.device()
                .flatMap(device -> device.features().stream().findFirst())
                .map(FeatureType::name)
                .orElse("...")
            + "))."
        : member + " has no feature " + Replies.shortened(name);
  }

  void callOff(String call) {
    link.cancel(member, news.boot(), call);
  }

  private static String conversation(ACLMessage message) {
    return Optional.ofNullable(message.getConversationId()).orElse("none");
  }

  public void cancel(Words words) {
    words.string("order").map(handles::get).ifPresent(RatsLink.CallHandle::cancel);
    Optional<String> life = words.string("life").filter(this::isOfThisBoot);
    life.flatMap(its -> words.string("call")).ifPresent(this::callOff);
  }

  /** A member may be asked to end what another has called, but not what it did in another life. */
  private boolean isOfThisBoot(String life) {
    return life.startsWith(news.boot() + "@");
  }

  private void answer(ACLMessage order, Outcome outcome, ActionDispatcher.Report report) {
    if (report.succeeded()) {
      agent.reply(
          order,
          ACLMessage.INFORM,
          Words.content(
              "inform",
              Stream.concat(
                      Stream.of(Words.terms("outputs", report.outputs())),
                      report.account().map(AccountWords::of).stream())
                  .toArray(Content.Argument[]::new)));
      return;
    }
    agent.reply(order, ACLMessage.FAILURE, Orders.failure(outcome, report));
  }

  /** The member raises an alarm: the coordinator is told, for people to hear. */
  private void alarm(Optional<String> goal, String message) {
    agent.send(
        agent.message(
            ACLMessage.INFORM,
            agent.getAID(AgentNames.COORDINATOR),
            Words.content(
                "inform",
                Words.named("member", Words.name(member)),
                Words.named("alert", Words.text(message)),
                Words.named("goal", Words.name(goal.orElse("none"))))));
  }

  /**
   * An alarm after its call's end, or of no call at all.
   *
   * @param call its id
   */
  public void alarmed(String call, String message) {
    alarm(Optional.ofNullable(recentGoals.get(call)), message);
  }

  /** Tells on what becomes of one call. */
  private final class Reporter implements CallReporter.Listener {
    private final String conversation;
    private final MemberOrders.Order order;
    private final Optional<AID> holder;
    private final BiConsumer<Outcome, ActionDispatcher.Report> reported;
    private Duration toldAlive = agent.clock().now();

    Reporter(
        String conversation,
        MemberOrders.Order order,
        Optional<AID> holder,
        BiConsumer<Outcome, ActionDispatcher.Report> reported) {
      this.conversation = conversation;
      this.order = order;
      this.holder = holder;
      this.reported = reported;
    }

    @Override
    public void reported(Outcome outcome, ActionDispatcher.Report report) {
      reported.accept(outcome, report);
    }

    @Override
    public void learnt(Map<String, Term> outputs) {
      List<Content.Argument> arguments = new ArrayList<>();
      arguments.add(Words.named("member", Words.name(member)));
      arguments.add(Words.named("feature", Words.name(order.feature().name())));
      order.goal().ifPresent(goal -> arguments.add(Words.named("goal", Words.name(goal))));
      arguments.add(Words.terms("bindings", order.bindings()));
      arguments.add(Words.terms("outputs", outputs));
      agent.send(
          agent.message(
              ACLMessage.INFORM,
              agent.getAID(AgentNames.KNOWLEDGE),
              new Content("inform", arguments)));
    }

    /** Of who is at it for long only: those who wait need no other sign. */
    @Override
    public void alive() {
      Duration now = agent.clock().now();
      if (now.minus(toldAlive).compareTo(order.timeout().dividedBy(2)) >= 0) {
        toldAlive = now;
        tellHolder(Words.named("alive", Words.name("true")));
      }
    }

    @Override
    public void alerted(String message) {
      alarm(order.goal(), message);
    }

    @Override
    public void offered(String by, Offer offer) {
      tellHolder(
          Words.named("offer", Words.name(by)),
          Words.named("cost", Words.number(offer.cost())),
          Words.named("seconds", Words.number(offer.seconds())));
    }

    @Override
    public void released(String reason) {
      tellHolder(Words.named("release", Words.text(reason)));
    }

    private void tellHolder(Content.Argument... news) {
      if (holder.isEmpty() || order.goal().isEmpty()) {
        return;
      }
      List<Content.Argument> arguments = new ArrayList<>();
      arguments.add(Words.named("member", Words.name(member)));
      arguments.add(Words.named("feature", Words.name(order.feature().name())));
      arguments.add(Words.named("goal", Words.name(order.goal().get())));
      arguments.addAll(List.of(news));
      agent.send(agent.message(ACLMessage.INFORM, holder.get(), new Content("inform", arguments)));
    }

    @Override
    public void over() {
      if (order.goal().isPresent() && !order.ends()) {
        arbitration.used(order.feature());
      }
      handles.remove(conversation);
      abandoned.remove(conversation);
    }
  }
}
