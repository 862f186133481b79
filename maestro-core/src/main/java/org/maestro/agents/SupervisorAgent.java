package org.maestro.agents;

import jade.lang.acl.ACLMessage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
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
              "The supervisor cannot " + action + "; it can take, stop and revive.");
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
    reply(
        message,
        ACLMessage.INFORM,
        Words.content(
            "inform",
            Words.named("broker", Words.text(handover.get().brokerUri())),
            Words.named("site", Words.text(handover.get().site())),
            Words.named("members", handover.get().members().stream().map(Words::text).toList())));
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
