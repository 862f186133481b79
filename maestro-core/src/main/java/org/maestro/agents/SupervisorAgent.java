package org.maestro.agents;

import jade.lang.acl.ACLMessage;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.agents.content.Addition;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.StartWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.Caller;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.runtime.PartGuard;
import org.maestro.agents.runtime.Spokesmen;
import org.maestro.agents.supervision.AgentChanges;
import org.maestro.agents.supervision.Containers;
import org.maestro.agents.supervision.Handover;
import org.maestro.agents.supervision.Introductions;
import org.maestro.agents.supervision.Newcomer;
import org.maestro.agents.supervision.RequestEnds;
import org.maestro.agents.supervision.SupervisorOrders;
import org.maestro.agents.supervision.TablesTold;
import org.maestro.agents.supervision.Welcome;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.ContainerStart;
import org.maestro.deployment.DeploymentException;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Part;
import org.maestro.rats.link.RatsLink;
import org.maestro.sl.Content;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Looks after containers and agents: lists them, adds, moves, configures and removes agents, takes
 * in containers that join from other processes, and stops everything (Three-layered architecture, 2
 * and 3.3.2; M3, M68-M72).
 *
 * <pre>
 * (perform (:action add) (:description "...") (:container lights))   and (:as NAME), (:needs a b)
 * (perform (:action move) (:agent lamp-9) (:to kitchen))
 * (perform (:action reconfigure) (:agent lamp-9) (:description "..."))
 * (perform (:action remove) (:agent lamp-9))                         also the agent of a room
 * (query-ref)                                                        the tables
 * (refer (:agent lamp-9))                     by proxy: passed on to who is asked for
 * </pre>
 */
public final class SupervisorAgent extends MaestroAgent {
  private static final long serialVersionUID = 1L;
  private static final Logger LOG = LoggerFactory.getLogger(SupervisorAgent.class);

  /** What processes ask for themselves; what they have to show for it is another matter. */
  private static final Set<String> OF_CONTAINERS = Set.of("join", "joined", "offer");

  private final transient RatsLink link;
  private final transient Containers containers;
  private final transient PartGuard parts;
  private final transient AgentChanges changes;
  private final transient TablesTold tables;
  private final transient Introductions introductions;
  private final transient SupervisorOrders orders = new SupervisorOrders(this);
  private final transient RequestEnds ends = new RequestEnds(this);

  /**
   * @param home as it is known at the time, which says who may order what
   * @param spokesmen who needs no permission
   */
  public SupervisorAgent(
      Birth birth,
      AgentTime time,
      RatsLink link,
      Containers containers,
      Supplier<Home> home,
      Spokesmen spokesmen) {
    super(birth, time);
    this.link = link;
    this.containers = containers;
    this.parts = new PartGuard(this, home, spokesmen);
    this.changes = new AgentChanges(this, containers);
    this.tables = new TablesTold(this, containers);
    this.introductions = new Introductions(this, containers);
  }

  /** What other agents are told and asked for it. Any thread may use it. */
  public SupervisorOrders orders() {
    return orders;
  }

  @Override
  protected void setup() {
    super.setup();
    pulse().ifPresent(containers::watchOver);
  }

  @Override
  protected void received(ACLMessage message) {
    for (Content content : Words.parse(message.getContent())) {
      Words words = Words.of(content);
      switch (content.operator()) {
        case "query-ref" -> tables.list(message);
        case "perform" -> perform(message, words);
        case "refer" -> introductions.refer(message, words);
        case StartWords.OPERATOR -> startedByHand(message, words);
        default ->
            refuse(
                message,
                ACLMessage.NOT_UNDERSTOOD,
                "The supervisor does not know the operator "
                    + Replies.shortened(content.operator())
                    + "; it knows query-ref, perform and refer.");
      }
    }
  }

  private void perform(ACLMessage message, Words words) {
    String action = words.string("action").orElse("");
    if (!OF_CONTAINERS.contains(action) && !parts.admits(message, words, Part.ADMINISTRATION)) {
      return;
    }
    switch (action) {
      case "join" ->
          beside(message, () -> admit(message, words), handover -> admitted(message, handover));
      case "joined" ->
          beside(
              message,
              () -> welcome(message, words),
              welcome -> welcomed(message, words.string("container").orElse(""), welcome));
      case "offer" -> offer(message, words);
      case "add" -> add(message, words);
      case "move" -> changes.move(message, words);
      case "reconfigure" -> changes.reconfigure(message, words);
      case "remove" ->
          beside(
              message,
              () -> removed(words.string("agent").orElse("")),
              gone -> ends.done(message, "The agent " + gone + " is removed."));
      case "stop" -> stop(message, words.string("member"));
      case "revive" ->
          beside(message, containers::reviveCoordinator, revived -> revived(message, revived));
      default ->
          refuse(
              message,
              ACLMessage.NOT_UNDERSTOOD,
              "The supervisor cannot do "
                  + Replies.shortened(action)
                  + "; it can add, move, reconfigure, remove, stop and revive.");
    }
  }

  private Handover admit(ACLMessage message, Words words) {
    Caller caller = Caller.of(message);
    containers.requireHost(caller);
    return containers.admit(container(words), caller.agent());
  }

  private Welcome welcome(ACLMessage message, Words words) {
    containers.requireHost(Caller.of(message));
    return containers.welcome(container(words));
  }

  private void stop(ACLMessage message, Optional<String> member) {
    if (member.isPresent()
        && link.members().stream().noneMatch(known -> known.id().equals(member.get()))) {
      refuse(
          message,
          ACLMessage.REFUSE,
          "There is no member %s on the bus; ./maestro agents lists those there are."
              .formatted(member.get()));
      return;
    }
    member.ifPresentOrElse(link::safe, link::safe);
    reply(
        message,
        ACLMessage.INFORM,
        Words.content("inform", Words.named("done", Words.name("stop"))));
  }

  /** What waits for JADE must not be done by an agent itself. */
  private <T> void beside(ACLMessage message, Supplier<T> work, Consumer<T> then) {
    Thread thread =
        new Thread(
            () -> {
              try {
                T result = work.get();
                tell(() -> then.accept(result));
              } catch (RuntimeException e) {
                tell(() -> ends.failed(message, e));
              }
            },
            "deployment");
    thread.setDaemon(true);
    thread.start();
  }

  private void offer(ACLMessage message, Words words) {
    String host = words.string("host").orElse("");
    List<String> provides = words.strings("provides");
    if (!message.getSender().getLocalName().equals(AgentNames.ofHost(host))) {
      refuse(message, ACLMessage.REFUSE, "A host is offered by its own agent only.");
      return;
    }
    try {
      containers.requireHost(Caller.of(message));
      containers
          .offered(host, provides)
          .ifPresentOrElse(
              handover -> admitted(message, handover),
              () ->
                  refuse(
                      message,
                      ACLMessage.REFUSE,
                      "The bus of this platform lives in its own process; agents elsewhere could"
                          + " not reach it."));
    } catch (IllegalArgumentException | DeploymentException e) {
      refuse(message, ACLMessage.REFUSE, Objects.requireNonNullElse(e.getMessage(), e.toString()));
    }
  }

  private static ContainerStart container(Words words) {
    return new ContainerStart(
        words.string("container").orElse(""),
        all(words, "topics"),
        all(words, "provides"),
        false,
        words.find("started").map(StartWords::process));
  }

  private static Set<String> all(Words words, String name) {
    Set<String> all = new TreeSet<>();
    words.find(name).ifPresent(w -> w.terms().forEach(term -> all.add(Words.plain(term))));
    return all;
  }

  private void admitted(ACLMessage message, Handover handover) {
    reply(message, ACLMessage.INFORM, handover.inWords());
  }

  /** The agents that are to move go when nothing is under way with them; nobody waits for that. */
  private void welcomed(ACLMessage message, String container, Welcome welcome) {
    for (String agent : welcome.toMove()) {
      changes.send(agent, container, answer -> {});
    }
    List<String> all = new ArrayList<>(welcome.begun().stream().map(AgentStart::agent).toList());
    all.addAll(welcome.toMove());
    List<Content> answer = new ArrayList<>();
    answer.add(
        Words.content("inform", Words.named("agents", all.stream().map(Words::text).toList())));
    welcome.begun().forEach(start -> answer.add(StartWords.content(start)));
    reply(message, ACLMessage.INFORM, answer.toArray(Content[]::new));
  }

  /** An agent that was not started here registers, and nobody for another (ADE, 3.1; A20). */
  private void startedByHand(ACLMessage message, Words words) {
    AgentStart start = StartWords.read(words);
    Caller caller = Caller.of(message);
    if (!start.agent().equals(caller.agent())) {
      refuse(message, ACLMessage.REFUSE, "An agent registers itself, and nobody does it for one.");
      return;
    }
    beside(
        message,
        () -> {
          registered(start, caller, StartWords.shown(words));
          return start;
        },
        taken -> ends.done(message, "The agent " + taken.agent() + " is registered."));
  }

  private void registered(AgentStart start, Caller caller, Optional<StartWords.Shown> shown) {
    try {
      containers.startedByHand(start, caller, shown);
    } catch (DeploymentException e) {
      LOG.warn("An agent that was started by hand is not taken in: {}", e.getMessage());
      throw e;
    }
  }

  private void add(ACLMessage message, Words words) {
    Optional<String> description = words.string("description");
    if (description.isEmpty()) {
      refuse(
          message,
          ACLMessage.REFUSE,
          "Whom to add is not said; write (perform (:action add) (:description \"<#lamp-9> a"
              + " ...\")).");
      return;
    }
    Addition addition =
        new Addition(
            description.get(),
            RequestEnds.source(words),
            words.string("as"),
            words.string("container"),
            all(words, "needs"));
    beside(
        message,
        () -> containers.add(addition),
        started ->
            reply(
                message,
                ACLMessage.INFORM,
                started.stream().map(SupervisorAgent::added).toArray(Content[]::new)));
  }

  private String removed(String agent) {
    containers.remove(agent);
    return agent;
  }

  private static Content added(Newcomer newcomer) {
    return Words.content(
        "inform",
        Words.named("agent", Words.name(newcomer.agent())),
        Words.named("container", Words.name(newcomer.container())),
        Words.named("text", Words.text(newcomer.sentence())));
  }

  private void revived(ACLMessage message, boolean revived) {
    if (revived) {
      reply(
          message,
          ACLMessage.INFORM,
          Words.content("inform", Words.named("done", Words.name("revive"))));
    } else {
      refuse(message, ACLMessage.REFUSE, "The central coordination agent (CCA) is there.");
    }
  }
}
