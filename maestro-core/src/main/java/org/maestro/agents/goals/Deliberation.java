package org.maestro.agents.goals;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.maestro.agents.calls.OwnMember;
import org.maestro.agents.content.ArbitrationWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.faces.FacedMessenger;
import org.maestro.agents.faces.Faces;
import org.maestro.agents.negotiation.AclActionDispatcher;
import org.maestro.agents.negotiation.AclContractNet;
import org.maestro.agents.negotiation.AclMessenger;
import org.maestro.agents.negotiation.Clients;
import org.maestro.agents.negotiation.Contracts;
import org.maestro.agents.negotiation.PermittedContractNet;
import org.maestro.agents.negotiation.ProtocolViolations;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.runtime.PlanningThread;
import org.maestro.coordination.Coordinator;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.ComponentWant;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Story;
import org.maestro.coordination.api.Thinking;
import org.maestro.coordination.api.Worth;
import org.maestro.rats.time.Clock;

/**
 * A coordinator as an agent has one: it bids, orders and hears over the agent's messages, and plans
 * beside the agent. Its scope are the members that it is told of. Agent thread only.
 */
public final class Deliberation {

  /** For so long a plan made again lets first plans go before it. */
  private static final Duration PATIENCE = Duration.ofSeconds(2);

  /** Wall time that another agent for a member has until it announces itself. */
  private static final Duration MOVE = Duration.ofSeconds(20);

  private final MaestroAgent agent;
  private final Clock clock;
  private final ReasoningServices mind;
  private final Predicate<String> scope;
  private final Faces faces;
  private final Contracts contracts = new Contracts();
  private final AclActionDispatcher dispatcher;
  private final Coordinator coordinator;
  private final PlanningThread planning = new PlanningThread();
  private final Map<String, AID> agentByMember = new HashMap<>();
  private volatile boolean ended;

  /**
   * Of an agent that orders other agents by messages.
   *
   * @param faces at which it is seen while it speaks
   */
  public Deliberation(
      MaestroAgent agent,
      Clock clock,
      ReasoningServices mind,
      Story story,
      Journal journal,
      ProtocolViolations misconduct,
      Faces faces) {
    this.agent = agent;
    this.clock = clock;
    this.mind = mind;
    this.scope = member -> true;
    this.faces = faces;
    Clients clients = new Clients(mind.knowledge(), this::requester, misconduct);
    this.dispatcher =
        new AclActionDispatcher(
            agent, this::agentOf, this::isDoubted, contracts, misconduct, clients::of);
    ContractNet contractNet =
        new PermittedContractNet(
            new AclContractNet(agent, this::agentOf, contracts, misconduct), clients);
    this.coordinator = new Coordinator(ports(clock, contractNet, dispatcher, story, journal));
  }

  /**
   * Of an agent with goals of its own.
   *
   * @param prefix before its goals' numbers
   * @param scope the members with which it plans
   * @param own the member that is the agent's own; empty: it orders other agents
   * @param faces at which it is seen while it speaks
   */
  public Deliberation(
      MaestroAgent agent,
      Clock clock,
      ReasoningServices mind,
      Story story,
      Journal journal,
      String prefix,
      Predicate<String> scope,
      ProtocolViolations misconduct,
      Optional<OwnMember> own,
      Faces faces) {
    this.agent = agent;
    this.clock = clock;
    this.mind = mind;
    this.scope = scope;
    this.faces = faces;
    this.dispatcher =
        new AclActionDispatcher(
            agent,
            this::agentOf,
            this::isDoubted,
            contracts,
            misconduct,
            goalId -> Optional.empty());
    ContractNet contractNet = new AclContractNet(agent, this::agentOf, contracts, misconduct);
    this.coordinator =
        new Coordinator(
            ports(
                clock,
                own.map(ContractNet.class::cast).orElse(contractNet),
                own.map(ActionDispatcher.class::cast).orElse(dispatcher),
                story,
                journal),
            prefix);
  }

  private Ports ports(
      Clock clock, ContractNet contractNet, ActionDispatcher orders, Story story, Journal journal) {
    return new Ports(
            mind.knowledge(),
            mind.planner(),
            contractNet,
            orders,
            new BesideTheAgent(clock, Duration.ZERO),
            action -> agent.tell(() -> unlessEnded(action)),
            clock,
            story,
            journal)
        .with(new FacedMessenger(new AclMessenger(agent), faces, this::timeUsed));
  }

  /** A goal of which nobody says what it is worth has all the time there is. */
  private double timeUsed(String goalId) {
    return coordinator.goals().stream()
        .filter(goal -> goal.id().equals(goalId))
        .flatMap(goal -> goal.worth().stream())
        .mapToDouble(Worth::timeUsed)
        .findFirst()
        .orElse(0);
  }

  public Coordinator coordinator() {
    return coordinator;
  }

  private Optional<String> requester(String goalId) {
    return coordinator.requester(goalId);
  }

  /**
   * From now on what changes in the collective knowledge is noticed. While there is no goal, that
   * is what members with which it plans have told: of a thousand agents without a goal, none is to
   * wake for what the other thousand say.
   */
  public void begin() {
    mind.knowledge()
        .watch(
            change -> {
              if (!ended && (coordinator.isAtWork() || scope.test(change.source().agent()))) {
                agent.tell(() -> coordinator.knowledgeChanged(change));
              }
            });
  }

  /** What is under way at members goes on; nobody here waits for it any more. */
  public void end() {
    ended = true;
    planning.end();
  }

  public int ordersUnderway() {
    return dispatcher.underwayCount();
  }

  public boolean contractsOpen() {
    return !contracts.isEmpty();
  }

  /** The goal's story is over. */
  public void forget(String goalId) {
    contracts.forget(goalId);
  }

  public void memberPresent(String member, AID its, Optional<String> life) {
    agentByMember.put(member, its);
    coordinator.memberPresent(member, life);
    dispatcher.agentThere(member);
  }

  public void memberLost(String member, String reason) {
    coordinator.memberLost(member, reason);
    dispatcher.memberLost(member);
  }

  /** A member's agent asks for what a goal of another manager wants of the member (A94). */
  public void askedToYield(ACLMessage message, Words words) {
    String sender = message.getSender().getLocalName();
    Optional<ComponentWant> want =
        ArbitrationWords.want(words, clock.now())
            .filter(w -> membersOf(sender).contains(w.member()));
    if (want.isEmpty()) {
      agent.refuse(
          message,
          ACLMessage.REFUSE,
          "Only a member's own agent has a manager give back what it has of that member: "
              + ArbitrationWords.YIELD_EXAMPLE);
      return;
    }
    agent.reply(
        message,
        ACLMessage.INFORM,
        Words.content("inform", Words.named("heard", Words.name(want.get().goalId()))));
    coordinator.wantedElsewhere(want.get());
  }

  /** Its agent gives no sign of life: nothing is asked of it until it does, or is lost. */
  public void agentDoubted(String member, String reason) {
    coordinator.memberDoubted(member, reason);
  }

  /** Its agent has given a sign of life again. */
  public void agentTrusted(String member) {
    if (agentByMember.containsKey(member)) {
      coordinator.memberTrusted(member);
      dispatcher.agentThere(member);
    }
  }

  /**
   * The agent is no more, and is to be there again soon, when it takes over what its members were
   * ordered; a member for which none has come in time is lost.
   *
   * @return the members that it stood for
   */
  public Set<String> agentMoves(String agentName) {
    Set<String> members = membersOf(agentName);
    for (String member : members) {
      agentByMember.remove(member);
      coordinator.memberDoubted(member, member + " is getting another agent");
      dispatcher.agentMoves(member);
      clock.schedule(
          agent.patience(MOVE), agent.getLocalName(), () -> agent.tell(() -> hasNotCome(member)));
    }
    agent.conversations().partnerEnded(agentName, agent.getAMS());
    return members;
  }

  private void hasNotCome(String member) {
    if (isAwaited(member)) {
      agentStaysAway(member, "it has had no agent for %d s".formatted(MOVE.toSeconds()));
    }
  }

  /** It has no agent, and this is why. */
  public void agentStaysAway(String member, String reason) {
    if (isAwaited(member)) {
      memberLost(member, reason);
    } else if (!agentByMember.containsKey(member)) {
      coordinator.memberAway(member, reason);
    }
  }

  /** Whether its agent has not come yet after it moved. */
  private boolean isAwaited(String member) {
    return isDoubted(member) && !agentByMember.containsKey(member);
  }

  private boolean isDoubted(String member) {
    return coordinator.isDoubted(member);
  }

  /** The agent is no more; returns the members that it stood for. */
  public Set<String> agentGone(String agentName, String reason) {
    Set<String> members = membersOf(agentName);
    for (String member : members) {
      agentByMember.remove(member);
      coordinator.memberLost(member, reason);
      dispatcher.agentEnded(member);
    }
    agent.conversations().partnerEnded(agentName, agent.getAMS());
    return members;
  }

  /** The members that the agent stands for. */
  public Set<String> membersOf(String agentName) {
    Set<String> members = new TreeSet<>();
    agentByMember.forEach(
        (member, its) -> {
          if (its.getLocalName().equals(agentName)) {
            members.add(member);
          }
        });
    return members;
  }

  private Optional<AID> agentOf(String member) {
    return coordinator.isPresent(member)
        ? Optional.ofNullable(agentByMember.get(member))
        : Optional.empty();
  }

  private void unlessEnded(Runnable action) {
    if (!ended) {
      action.run();
    }
  }

  /** Plans beside the agent, and hands the result back through the clock. */
  private final class BesideTheAgent implements Thinking {
    private final Clock clock;
    private final Duration patience;

    private BesideTheAgent(Clock clock, Duration patience) {
      this.clock = clock;
      this.patience = patience;
    }

    @Override
    public Thinking patient() {
      return new BesideTheAgent(clock, PATIENCE);
    }

    @Override
    public <T> void think(Supplier<T> work, Consumer<T> then) {
      // An event of its own, so that on a stepped clock the agent is idle while it is planned.
      clock.schedule(Duration.ZERO, agent.getLocalName(), () -> begin(work, then));
    }

    private <T> void begin(Supplier<T> work, Consumer<T> then) {
      if (ended) {
        return;
      }
      Clock.Ticket ticket = clock.hold("planning");
      planning.execute(
          () -> {
            try {
              T result = work.get();
              clock.schedule(
                  mind.decisionTime(),
                  agent.getLocalName(),
                  () -> agent.tell(() -> unlessEnded(() -> then.accept(result))));
            } finally {
              ticket.close();
            }
          },
          patience);
    }
  }
}
