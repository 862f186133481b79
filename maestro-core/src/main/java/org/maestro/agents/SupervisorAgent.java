package org.maestro.agents;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.agents.pulse.Pulse;
import org.maestro.rats.link.RatsLink;
import org.maestro.sl.Content;

/**
 * Looks after containers and agents: lists them, hands a topic's members over to a container that
 * joins from another process, and stops everything.
 */
public final class SupervisorAgent extends MaestroAgent {
  private static final long serialVersionUID = 1L;

  public static final String NAME = "supervisor";

  private static final Duration HOST_WITHIN = Duration.ofSeconds(10);

  /** What a joining container takes over. */
  public record Handover(String brokerUri, String site, List<String> members) {}

  /** A line of the list of agents. */
  public record Line(String agent, String container, String phase, String state) {}

  /** The containers of this process. Any thread may call. */
  public interface Containers {
    /**
     * Ends the topic's container here; empty when there is none, or the bus cannot be reached from
     * elsewhere.
     */
    Optional<Handover> release(String topic);

    /** Why the topic's container has to stay here, in a sentence; empty when it need not. */
    Optional<String> tie(String topic);

    List<String> topics();

    /** Starts the central agent again; returns false when it is there. */
    boolean reviveCoordinator();

    List<Line> agents();

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
        default ->
            refuse(
                message,
                ACLMessage.NOT_UNDERSTOOD,
                "The supervisor does not know the operator "
                    + content.operator()
                    + "; it knows query-ref and perform.");
      }
    }
  }

  private void perform(ACLMessage message, Words words) {
    String action = words.string("action").orElse("");
    switch (action) {
      case "take" -> handOver(message, words);
      case "offer" -> offer(message, words);
      case "stop" -> {
        link.safe();
        reply(
            message,
            ACLMessage.INFORM,
            Words.content("inform", Words.named("done", Words.name("stop"))));
      }
      case "revive" -> revive(message);
      default ->
          refuse(
              message,
              ACLMessage.NOT_UNDERSTOOD,
              "The supervisor cannot " + action + "; it can take, offer, stop and revive.");
    }
  }

  /** Starting an agent waits for JADE, which an agent must not. */
  private void revive(ACLMessage message) {
    Thread starter =
        new Thread(
            () -> {
              boolean revived = containers.reviveCoordinator();
              tell(() -> revived(message, revived));
            },
            "revival");
    starter.setDaemon(true);
    starter.start();
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
              handover -> answer(message, handover),
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
   * Has a host start a member's agent. Any thread may call.
   *
   * @param problem is told on this agent's thread why it is not started, or nothing when it is
   */
  public void beginOn(
      String host, String member, String controller, Consumer<Optional<String>> problem) {
    tell(
        () ->
            ask(
                message(
                    ACLMessage.REQUEST,
                    getAID(HostAgent.name(host)),
                    Words.content(
                        "perform",
                        Words.named("action", Words.name("host")),
                        Words.named("member", Words.text(member)),
                        Words.named("controller", Words.text(controller)))),
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

  /** Ending a container waits for JADE, which an agent must not. */
  private void handOver(ACLMessage message, Words words) {
    String topic = words.string("topic").orElse("");
    Optional<String> tie = containers.tie(topic);
    if (tie.isPresent()) {
      refuse(message, ACLMessage.REFUSE, tie.get());
      return;
    }
    Thread hand =
        new Thread(
            () -> {
              Optional<Handover> handover = containers.release(topic);
              tell(() -> answer(message, topic, handover));
            },
            "hand-over");
    hand.setDaemon(true);
    hand.start();
  }

  private void answer(ACLMessage message, String topic, Optional<Handover> handover) {
    if (handover.isEmpty()) {
      refuse(
          message,
          ACLMessage.REFUSE,
          "There is no container for "
              + topic
              + " to take over; there are "
              + String.join(", ", containers.topics())
              + ".");
      return;
    }
    answer(message, handover.get());
  }

  private void answer(ACLMessage message, Handover handover) {
    reply(
        message,
        ACLMessage.INFORM,
        Words.content(
            "inform",
            Words.named("broker", Words.text(handover.brokerUri())),
            Words.named("site", Words.text(handover.site())),
            Words.named("members", handover.members().stream().map(Words::text).toList())));
  }

  private void list(ACLMessage message) {
    List<Content> lines = new ArrayList<>();
    for (Line line : containers.agents()) {
      lines.add(
          Words.content(
              "inform",
              Words.named("agent", Words.text(line.agent())),
              Words.named("container", Words.text(line.container())),
              Words.named("phase", Words.name(line.phase())),
              Words.named("state", Words.text(line.state()))));
    }
    reply(message, ACLMessage.INFORM, lines.toArray(Content[]::new));
  }
}
