package org.maestro.agents.rooms;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.maestro.agents.centre.Said;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.SaidReply;
import org.maestro.agents.content.SayWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.faces.Faces;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.dialogue.SpokenWords;
import org.maestro.dialogue.Utterance;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Content;

/**
 * The contract net among the agents of rooms over something that was said in one of them and is not
 * understood there (ADE, 5; A72, A87): of those that understand it, the one does it that has a
 * place for most of its words, or else has most of the things it speaks of; its answers are told by
 * the first. Agent thread only.
 */
final class RoundOfRooms {
  private static final Duration NO_END = Duration.ofDays(365);

  private final MaestroAgent agent;
  private final String name;
  private final Supplier<Home> home;
  private final Faces faces;

  /**
   * @param name of the agent that passes things on
   * @param faces at which it is seen
   */
  RoundOfRooms(MaestroAgent agent, String name, Supplier<Home> home, Faces faces) {
    this.agent = agent;
    this.faces = faces;
    this.name = name;
    this.home = home;
  }

  /** What comes of a round: exactly one of both is told, once. */
  interface Outcome {
    /**
     * An agent understands it, and is to be told whether it is to do it.
     *
     * @param later the wall time that the round has taken
     */
    void understood(ACLMessage proposal, Duration later);

    /**
     * @param reason a sentence
     */
    void notUnderstood(String reason);
  }

  /**
   * Asks the agents of all other rooms.
   *
   * @param grasp what it is here
   */
  void ask(Utterance utterance, SpokenWords.Grasp grasp, Outcome outcome) {
    List<String> rooms = others();
    Round round = new Round(grasp, outcome, agent.clock().now(), rooms.size());
    if (rooms.isEmpty()) {
      round.close();
    }
    for (String other : rooms) {
      agent.ask(
          agent.message(ACLMessage.CFP, agent.getAID(other), SayWords.asking(utterance)),
          agent.patience().bid(),
          round::answered);
    }
  }

  /**
   * Has it done by the agent of another room.
   *
   * @param grasp what it is here
   */
  void passOn(Said said, SpokenWords.Grasp grasp) {
    ask(
        said.utterance(),
        grasp,
        new Outcome() {
          @Override
          public void understood(ACLMessage proposal, Duration later) {
            award(said, proposal, later);
          }

          @Override
          public void notUnderstood(String reason) {
            agent.refuse(said.message(), ACLMessage.REFUSE, reason);
            faces.answered(said.utterance(), new SaidReply.Refused(reason));
          }
        });
  }

  private void award(Said said, ACLMessage proposal, Duration later) {
    String winner = proposal.getSender().getLocalName();
    agent.ask(
        agent.message(
            ACLMessage.ACCEPT_PROPOSAL,
            proposal.getSender(),
            SayWords.passedOn(said.utterance(), said.caller().toString())),
        NO_END,
        reply -> relay(said, winner, later, reply));
  }

  private void relay(Said said, String winner, Duration later, ACLMessage reply) {
    if (Replies.isFromPlatform(reply)) {
      agent.refuse(
          said.message(),
          ACLMessage.FAILURE,
          "%s understood that, and has ended meanwhile; say it again.".formatted(winner));
    } else {
      agent.reply(
          said.message(),
          reply.getPerformative(),
          SayWords.through(Words.parse(reply.getContent()), winner, later).toArray(Content[]::new));
    }
  }

  /** It is not to do it: another does, or who has asked does it himself. */
  void reject(ACLMessage proposal, String reason) {
    agent.reply(
        proposal,
        ACLMessage.REJECT_PROPOSAL,
        Words.content("inform", Words.named("reason", Words.text(reason))));
  }

  private List<String> others() {
    return home.get().groups().values().stream()
        .filter(group -> group.hearing().isPresent() && !group.id().equals(name))
        .map(Group::id)
        .toList();
  }

  private static double number(ACLMessage answer, String what) {
    return Words.of(Words.parse(answer.getContent()).get(0)).number(what, 0);
  }

  /** One call for proposals. */
  private final class Round {
    private final SpokenWords.Grasp grasp;
    private final Outcome outcome;
    private final Duration began;
    private final List<ACLMessage> proposals = new ArrayList<>();
    private final List<ACLMessage> refusals = new ArrayList<>();
    private int awaited;

    Round(SpokenWords.Grasp grasp, Outcome outcome, Duration began, int awaited) {
      this.grasp = grasp;
      this.outcome = outcome;
      this.began = began;
      this.awaited = awaited;
    }

    void answered(ACLMessage answer) {
      if (answer.getPerformative() == ACLMessage.PROPOSE) {
        proposals.add(answer);
      } else if (answer.getPerformative() == ACLMessage.REFUSE) {
        refusals.add(answer);
      }
      awaited--;
      if (awaited == 0) {
        close();
      }
    }

    void close() {
      Optional<ACLMessage> best = best(proposals);
      proposals.stream()
          .filter(other -> best.filter(other::equals).isEmpty())
          .forEach(other -> reject(other, "Another room has a place for more of the words."));
      best.ifPresentOrElse(
          proposal ->
              outcome.understood(proposal, agent.clock().toWall(agent.clock().now().minus(began))),
          () -> outcome.notUnderstood(reason()));
    }

    private static Optional<ACLMessage> best(List<ACLMessage> answers) {
      return answers.stream()
          .min(
              Comparator.comparingDouble((ACLMessage answer) -> -number(answer, "coverage"))
                  .thenComparingDouble(answer -> -number(answer, "own"))
                  .thenComparing(answer -> answer.getSender().getLocalName()));
    }

    /** Who has understood most of it says what of it he does not know. */
    private String reason() {
      return best(refusals)
          .filter(answer -> number(answer, "coverage") > grasp.coverage())
          .flatMap(Replies::reason)
          .or(grasp::reply)
          .orElse("That is not understood in any room; say it in other words.");
    }
  }
}
