package org.maestro.agents.rooms;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.maestro.agents.centre.Said;
import org.maestro.agents.centre.Sayings;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.SayWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.faces.Faces;
import org.maestro.agents.runtime.Conversations;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.dialogue.Dialogues;
import org.maestro.dialogue.SpokenWords;
import org.maestro.dialogue.Utterance;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.sl.Content;

/**
 * The hearing of an agent of a room (ADE, 5; A13, A77, A87, A91). What it understands with the
 * words of its topics it has done by the central agent, and does itself, with what the room has,
 * while there is none; what it does not understand, the room does that understands most of it.
 * Agent thread only.
 */
public final class RoomListening {
  private static final Duration NO_END = Duration.ofDays(365);

  private final MaestroAgent agent;
  private final String name;
  private final Predicate<String> isMember;
  private final KnowledgeBase knowledge;
  private final Dialogues dialogues;
  private final Sayings own;
  private final RoundOfRooms others;
  private final Set<HandedOver> atTheCentre = new LinkedHashSet<>();

  /**
   * @param name the agent's, as the home has it
   * @param isMember whether a device is one of the room's
   * @param own what it does itself
   * @param faces at which it is seen
   */
  public RoomListening(
      MaestroAgent agent,
      String name,
      Predicate<String> isMember,
      KnowledgeBase knowledge,
      Dialogues dialogues,
      Sayings own,
      Faces faces) {
    this.agent = agent;
    this.name = name;
    this.isMember = isMember;
    this.knowledge = knowledge;
    this.dialogues = dialogues;
    this.own = own;
    this.others = new RoundOfRooms(agent, name, knowledge::home, faces);
  }

  /** Somebody says something, here, or where it was not understood. */
  public void say(ACLMessage message, Words words) {
    Said.of(agent, knowledge.home(), message, words)
        .map(said -> said.heardBy(name))
        .ifPresent(this::hear);
  }

  private void hear(Said said) {
    boolean isAwarded = said.message().getPerformative() == ACLMessage.ACCEPT_PROPOSAL;
    boolean isUnfinished = said.words().string("more").isPresent();
    boolean isAnAnswer = dialogues.asked().answeredBy(said.utterance()).isPresent();
    if (isAwarded || isUnfinished || isAnAnswer) {
      carryOut(said);
      return;
    }
    SpokenWords.Grasp grasp = grasp(said.utterance());
    if (grasp.isUnderstood()) {
      carryOut(said);
    } else {
      others.passOn(said, grasp);
    }
  }

  private SpokenWords.Grasp grasp(Utterance heard) {
    return dialogues.with(heard.person()).grasp(heard);
  }

  /**
   * The agent of another room asks who understands what was said there, or somebody who does things
   * himself asks it of all rooms.
   */
  public void understand(ACLMessage message, Words words) {
    Optional<String> text = words.terms().stream().findFirst().map(Words::plain);
    boolean isAsked =
        message.getPerformative() == ACLMessage.CFP
            || message.getPerformative() == ACLMessage.REQUEST;
    if (!isAsked || text.isEmpty() || words.string("by").isEmpty()) {
      agent.refuse(
          message,
          ACLMessage.NOT_UNDERSTOOD,
          "Who understands something is asked by a call for proposals with the words, who speaks,"
              + " and where, such as (understand \"turn on the light\" (:by Bob) (:in livingroom));"
              + " a request asks it of all rooms.");
      return;
    }
    Utterance heard =
        new Utterance(
                words.string("by").orElseThrow(),
                words.string("in").orElse(""),
                text.get(),
                Optional.empty())
            .heardBy(name);
    SpokenWords.Grasp grasp = grasp(heard);
    if (message.getPerformative() == ACLMessage.REQUEST) {
      ofAll(message, heard, grasp);
    } else if (grasp.isUnderstood()) {
      agent.reply(message, ACLMessage.PROPOSE, SayWords.proposed(grasp, own(grasp)));
    } else {
      agent.reply(message, ACLMessage.REFUSE, SayWords.declined(grasp));
    }
  }

  private int own(SpokenWords.Grasp grasp) {
    return grasp.mentioned().stream().filter(isMember).toList().size();
  }

  private void ofAll(ACLMessage message, Utterance heard, SpokenWords.Grasp grasp) {
    if (grasp.isUnderstood()) {
      agent.reply(message, ACLMessage.INFORM, SayWords.understood(name, Duration.ZERO));
      return;
    }
    others.ask(
        heard,
        grasp,
        new RoundOfRooms.Outcome() {
          @Override
          public void understood(ACLMessage proposal, Duration later) {
            others.reject(proposal, "Who has asked does it with the words of this room.");
            agent.reply(
                message,
                ACLMessage.INFORM,
                SayWords.understood(proposal.getSender().getLocalName(), later));
          }

          @Override
          public void notUnderstood(String reason) {
            agent.refuse(message, ACLMessage.REFUSE, reason);
          }
        });
  }

  /** All answers of who does it are told to who said it. */
  private void carryOut(Said said) {
    HandedOver handedOver = new HandedOver(said);
    handedOver.conversation =
        agent
            .conversations()
            .ask(
                agent.message(
                    ACLMessage.REQUEST, agent.getAID(AgentNames.COORDINATOR), request(said)),
                NO_END,
                reply -> answered(handedOver, reply));
    atTheCentre.add(handedOver);
  }

  /** What was passed on to the central agent, and has no final answer yet. */
  private static final class HandedOver {
    private final Said said;
    private String conversation = "";
    private boolean isTakenOn;

    HandedOver(Said said) {
      this.said = said;
    }
  }

  private void answered(HandedOver handedOver, ACLMessage reply) {
    if (Conversations.isFinal(reply)) {
      atTheCentre.remove(handedOver);
    }
    if (Replies.isFromPlatform(reply)) {
      withoutCentre(handedOver);
    } else {
      handedOver.isTakenOn |= reply.getPerformative() == ACLMessage.AGREE;
      tell(handedOver.said, reply.getPerformative(), Words.parse(reply.getContent()));
    }
  }

  /** The central agent is no more, and answers nothing that it was told before. */
  public void centreDied() {
    List<HandedOver> unanswered = List.copyOf(atTheCentre);
    atTheCentre.clear();
    for (HandedOver handedOver : unanswered) {
      agent.conversations().close(handedOver.conversation);
      agent.work(() -> withoutCentre(handedOver));
    }
  }

  private void withoutCentre(HandedOver handedOver) {
    if (handedOver.isTakenOn) {
      agent.refuse(
          handedOver.said.message(),
          ACLMessage.FAILURE,
          "The central agent has ended meanwhile; what runs goes on, and nobody tells how it"
              + " ends.");
    } else {
      own.hear(handedOver.said);
    }
  }

  private static Content request(Said said) {
    Content whole = SayWords.passedOn(said.utterance(), said.caller().toString());
    return said.words().string("more").isEmpty() ? whole : SayWords.goingOn(whole);
  }

  private void tell(Said said, int performative, List<Content> contents) {
    agent.reply(said.message(), performative, contents.toArray(Content[]::new));
  }
}
