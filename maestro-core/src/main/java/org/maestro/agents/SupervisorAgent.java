package org.maestro.agents;

import jade.domain.DFService;
import jade.domain.FIPAAgentManagement.DFAgentDescription;
import jade.domain.FIPAAgentManagement.FIPAManagementVocabulary;
import jade.domain.FIPAAgentManagement.SearchConstraints;
import jade.domain.FIPAAgentManagement.ServiceDescription;
import jade.domain.FIPAException;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.agents.pulse.Pulse;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.ContainerStart;
import org.maestro.deployment.DeploymentException;
import org.maestro.rats.link.RatsLink;
import org.maestro.sl.Content;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Looks after containers and agents: lists them, adds, moves, configures and removes agents, takes
 * in containers that join from other processes, and stops everything (M3, M68-M72).
 *
 * <pre>
 * (perform (:action add) (:description "...") (:container lights))   and (:as NAME), (:needs a b)
 * (perform (:action move) (:agent lamp-9) (:to kitchen))
 * (perform (:action reconfigure) (:agent lamp-9) (:description "..."))
 * (perform (:action remove) (:agent lamp-9))
 * (query-ref)                                                        the tables
 * </pre>
 */
public final class SupervisorAgent extends MaestroAgent {
  private static final long serialVersionUID = 1L;
  private static final Logger LOG = LoggerFactory.getLogger(SupervisorAgent.class);
  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(10);
  private static final Duration HOST_WITHIN = Duration.ofSeconds(10);
  private static final Duration MOVES_WITHIN = Duration.ofSeconds(100);

  public static final String NAME = "supervisor";

  /**
   * What a joining container is told of the bus, and of what is said there.
   *
   * @param words what the home adds to the shipped vocabulary, as Turtle; empty when it adds
   *     nothing
   */
  public record Handover(String brokerUri, String site, String words) {
    /** Reads what {@link #inWords} has written. */
    public static Handover read(Words answer) {
      return new Handover(
          answer.string("broker").orElseThrow(),
          answer.string("site").orElseThrow(),
          answer.string("words").orElse(""));
    }

    Content inWords() {
      return Words.content(
          "inform",
          Words.named("broker", Words.text(brokerUri)),
          Words.named("site", Words.text(site)),
          Words.named("words", Words.text(words)));
    }
  }

  /**
   * What is asked for by {@code add}.
   *
   * @param description of one device or several, as Turtle or JSON-LD
   * @param source how faults call the description, such as a file's name
   * @param as the name of one agent for all of them; empty: an agent for each
   * @param container empty: the usual one
   */
  public record Addition(
      String description,
      String source,
      Optional<String> as,
      Optional<String> container,
      Set<String> needs) {}

  /**
   * The containers and agents of the platform. Any thread may call. What cannot be done throws a
   * RuntimeException with one sentence; what waits for JADE says so.
   */
  public interface Containers {
    /**
     * Waits for JADE: makes room for the container, whose name a topic's container here may have.
     */
    Handover admit(ContainerStart container);

    /**
     * Waits for JADE: the container is there; returns the agents that begin or are to move there.
     */
    Welcome welcome(ContainerStart container);

    /** Waits for JADE; returns who was started. */
    List<AgentStart> add(Addition addition);

    /** An agent has been started by other means. */
    void startedByHand(AgentStart start);

    /** Returns whom to ask. */
    AgentStart requireMovable(String agent, String container);

    void moved(String agent, String container);

    /**
     * How the agent is to be configured.
     *
     * @param source how faults call the description
     */
    AgentStart reconfigured(String agent, String description, String source);

    void configured(AgentStart start);

    /** Waits for JADE. */
    AgentStart remove(String agent);

    /** Waits for JADE: starts the central agent again; returns false when it is there. */
    boolean reviveCoordinator();

    /**
     * A line for each agent, and for each container.
     *
     * @param services what the directory facilitator has, by agent
     */
    List<Content> tables(Map<String, ? extends Set<String>> services);

    /**
     * A process offers itself as a host for agents, by its {@link HostAgent}.
     *
     * @return where the bus is; empty: it cannot be reached from elsewhere
     * @throws IllegalArgumentException with one sentence when something that it provides cannot be
     *     read
     */
    default Optional<Handover> offered(String host, List<String> provides) {
      return Optional.empty();
    }

    /** The supervisor is there, and can hear who is alive. */
    default void watchOver(Pulse pulse) {
      // Where nobody is missed nobody is watched.
    }
  }

  /** Agents that a container which joined is to begin, and that are asked to move there. */
  public record Welcome(List<AgentStart> begun, List<String> toMove) {}

  private final transient RatsLink link;
  private final transient Containers containers;

  public SupervisorAgent(AgentTime time, RatsLink link, Containers containers) {
    super(time);
    this.link = link;
    this.containers = containers;
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
        case "query-ref" -> list(message);
        case "perform" -> perform(message, words);
        case StartWords.OPERATOR -> startedByHand(StartWords.read(words));
        default ->
            refuse(
                message,
                ACLMessage.NOT_UNDERSTOOD,
                "The supervisor does not know the operator "
                    + Replies.shortened(content.operator())
                    + "; it knows query-ref and perform.");
      }
    }
  }

  private void perform(ACLMessage message, Words words) {
    String action = words.string("action").orElse("");
    switch (action) {
      case "join" ->
          beside(message, () -> containers.admit(container(words)), h -> admitted(message, h));
      case "joined" ->
          beside(
              message,
              () -> containers.welcome(container(words)),
              welcome -> welcomed(message, words.string("container").orElse(""), welcome));
      case "offer" -> offer(message, words);
      case "add" -> add(message, words);
      case "move" -> move(message, words);
      case "reconfigure" -> reconfigure(message, words);
      case "remove" ->
          beside(
              message,
              () -> containers.remove(words.string("agent").orElse("")),
              gone -> done(message, "The agent " + gone.agent() + " is removed."));
      case "stop" -> {
        link.safe();
        reply(
            message,
            ACLMessage.INFORM,
            Words.content("inform", Words.named("done", Words.name("stop"))));
      }
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

  /** What waits for JADE must not be done by an agent itself. */
  private <T> void beside(ACLMessage message, Supplier<T> work, Consumer<T> then) {
    Thread thread =
        new Thread(
            () -> {
              try {
                T result = work.get();
                tell(() -> then.accept(result));
              } catch (RuntimeException e) {
                tell(() -> no(message, e));
              }
            },
            "deployment");
    thread.setDaemon(true);
    thread.start();
  }

  private void no(ACLMessage message, RuntimeException why) {
    if (!(why instanceof DeploymentException)) {
      LOG.warn("What {} asked for cannot be done", Replies.sender(message), why);
    }
    refuse(message, ACLMessage.REFUSE, String.valueOf(why.getMessage()));
  }

  private void done(ACLMessage message, String sentence) {
    reply(
        message,
        ACLMessage.INFORM,
        Words.content("inform", Words.named("text", Words.text(sentence))));
  }

  private void offer(ACLMessage message, Words words) {
    String host = words.string("host").orElse("");
    List<String> provides =
        words.find("provides").map(Words::terms).orElse(List.of()).stream()
            .map(Words::plain)
            .toList();
    if (!message.getSender().getLocalName().equals(HostAgent.name(host))) {
      refuse(message, ACLMessage.REFUSE, "A host is offered by its own agent only.");
      return;
    }
    try {
      containers
          .offered(host, provides)
          .ifPresentOrElse(
              handover -> admitted(message, handover),
              () ->
                  refuse(
                      message,
                      ACLMessage.REFUSE,
                      "The bus of this platform lives in its own process; agents elsewhere could not reach it."));
    } catch (IllegalArgumentException e) {
      refuse(message, ACLMessage.REFUSE, e.getMessage());
    }
  }

  /**
   * Has a host start an agent, configured as it was. Any thread may call.
   *
   * @param problem is told on this agent's thread why it is not started, or nothing when it is
   */
  public void beginOn(
      String host, AgentStart start, String controller, Consumer<Optional<String>> problem) {
    tell(
        () ->
            ask(
                message(
                    ACLMessage.REQUEST,
                    getAID(HostAgent.name(host)),
                    Words.content(
                        "perform",
                        Words.named("action", Words.name("host")),
                        Words.named("controller", Words.text(controller))),
                    StartWords.content(start)),
                HOST_WITHIN,
                reply -> {
                  if (Conversations.isFinal(reply)) {
                    problem.accept(
                        reply.getPerformative() == ACLMessage.INFORM
                            ? Optional.empty()
                            : Replies.reason(reply).or(() -> Optional.of("no answer")));
                  }
                }));
  }

  /**
   * Has a host end its calls under a controller's name, and waits for that; not to be called by an
   * agent.
   */
  public void letGo(String host, String controller) {
    CompletableFuture<ACLMessage> answered = new CompletableFuture<>();
    tell(
        () ->
            ask(
                message(
                    ACLMessage.REQUEST,
                    getAID(HostAgent.name(host)),
                    Words.content(
                        "perform",
                        Words.named("action", Words.name("let-go")),
                        Words.named("controller", Words.text(controller)))),
                HOST_WITHIN,
                reply -> {
                  if (Conversations.isFinal(reply)) {
                    answered.complete(reply);
                  }
                }));
    // The conversation ends in any case, also when the host is gone: then its calls are over too.
    answered.join();
  }

  /** Tells agents that count on a member that it is gone. Any thread may call. */
  public void tellLost(String member, String reason, Collection<String> agents) {
    tell(
        () ->
            agents.forEach(
                agent ->
                    send(
                        message(
                            ACLMessage.INFORM,
                            getAID(agent),
                            Words.content(
                                "inform",
                                Words.named("member", Words.name(member)),
                                Words.named("phase", Words.name("lost")),
                                Words.named("reason", Words.text(reason)))))));
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
      send(agent, container, answer -> {});
    }
    List<String> all = new ArrayList<>(welcome.begun().stream().map(AgentStart::agent).toList());
    all.addAll(welcome.toMove());
    List<Content> answer = new ArrayList<>();
    answer.add(
        Words.content("inform", Words.named("agents", all.stream().map(Words::text).toList())));
    welcome.begun().forEach(start -> answer.add(StartWords.content(start)));
    reply(message, ACLMessage.INFORM, answer.toArray(Content[]::new));
  }

  private void startedByHand(AgentStart start) {
    try {
      containers.startedByHand(start);
    } catch (DeploymentException e) {
      LOG.warn("An agent that was started by hand is not looked after: {}", e.getMessage());
    }
  }

  private void add(ACLMessage message, Words words) {
    Optional<String> description = words.string("description");
    if (description.isEmpty()) {
      refuse(
          message,
          ACLMessage.REFUSE,
          "Whom to add is not said; write (perform (:action add) (:description \"<#lamp-9> a ...\")).");
      return;
    }
    Addition addition =
        new Addition(
            description.get(),
            source(words),
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

  private static String source(Words words) {
    return words.string("file").orElse("the description");
  }

  private static Content added(AgentStart start) {
    String members =
        start.members().equals(List.of(start.agent()))
            ? ""
            : ", and stands for " + String.join(", ", start.members());
    return Words.content(
        "inform",
        Words.named("agent", Words.name(start.agent())),
        Words.named("container", Words.name(start.container())),
        Words.named(
            "text",
            Words.text(
                "The agent %s lives in %s%s."
                    .formatted(start.agent(), start.container(), members))));
  }

  private void move(ACLMessage message, Words words) {
    String agent = words.string("agent").orElse("");
    String container = words.string("to").orElse("");
    try {
      containers.requireMovable(agent, container);
    } catch (DeploymentException e) {
      refuse(message, ACLMessage.REFUSE, e.getMessage());
      return;
    }
    send(
        agent,
        container,
        answer -> {
          if (answer.getPerformative() == ACLMessage.INFORM) {
            done(message, "The agent " + agent + " lives in " + container + " now.");
          } else {
            refuse(
                message,
                answer.getPerformative() == ACLMessage.REFUSE
                    ? ACLMessage.REFUSE
                    : ACLMessage.FAILURE,
                Replies.reason(answer)
                    .orElse("The agent " + agent + " does not answer; is its container alive?"));
          }
        });
  }

  private void send(String agent, String container, Consumer<ACLMessage> ended) {
    ask(
        message(
            ACLMessage.REQUEST,
            getAID(agent),
            Words.content(
                "perform",
                Words.named("action", Words.name("move")),
                Words.named("container", Words.name(container)))),
        MOVES_WITHIN,
        answer -> {
          if (answer.getPerformative() != ACLMessage.AGREE) {
            if (answer.getPerformative() == ACLMessage.INFORM) {
              containers.moved(agent, container);
            }
            ended.accept(answer);
          }
        });
  }

  private void reconfigure(ACLMessage message, Words words) {
    String agent = words.string("agent").orElse("");
    try {
      AgentStart wanted =
          containers.reconfigured(agent, words.string("description").orElse(""), source(words));
      List<Content.Argument> arguments = new ArrayList<>();
      arguments.add(Words.named("action", Words.name("configure")));
      arguments.addAll(StartWords.charges(wanted.charges()));
      ask(
          message(ACLMessage.REQUEST, getAID(agent), new Content("perform", arguments)),
          ANSWER_WITHIN,
          answer -> {
            if (answer.getPerformative() == ACLMessage.INFORM) {
              containers.configured(wanted);
              done(message, "The agent " + agent + " is configured anew.");
            } else if (answer.getPerformative() != ACLMessage.AGREE) {
              refuse(
                  message,
                  ACLMessage.REFUSE,
                  Replies.reason(answer).orElse("The agent " + agent + " does not answer."));
            }
          });
    } catch (RuntimeException e) {
      no(message, e);
    }
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

  /** The yellow pages are asked first. */
  private void list(ACLMessage message) {
    SearchConstraints all = new SearchConstraints();
    all.setMaxResults(-1L);
    ask(
        DFService.createRequestMessage(
            this, getDefaultDF(), FIPAManagementVocabulary.SEARCH, new DFAgentDescription(), all),
        ANSWER_WITHIN,
        answer ->
            reply(
                message,
                ACLMessage.INFORM,
                containers.tables(services(answer)).toArray(Content[]::new)));
  }

  private static Map<String, Set<String>> services(ACLMessage answer) {
    Map<String, Set<String>> services = new TreeMap<>();
    if (answer.getPerformative() != ACLMessage.INFORM) {
      return services;
    }
    try {
      for (DFAgentDescription entry : DFService.decodeResult(answer.getContent())) {
        Set<String> types =
            services.computeIfAbsent(entry.getName().getLocalName(), n -> new TreeSet<>());
        for (var all = entry.getAllServices(); all.hasNext(); ) {
          types.add(((ServiceDescription) all.next()).getType());
        }
      }
    } catch (FIPAException e) {
      LOG.warn("The yellow pages answer unreadably: {}", e.getMessage());
    }
    return services;
  }
}
