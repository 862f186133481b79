package org.maestro.agents.centre;

import jade.lang.acl.ACLMessage;
import java.util.Optional;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.Caller;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.Requester;
import org.maestro.dialogue.Utterance;
import org.maestro.dialogue.UtteranceCheck;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Home;

/** Something that was said, and who tells it. */
public record Said(ACLMessage message, Words words, Caller caller, Utterance utterance) {

  /**
   * What a message tells that somebody says; who sends one that tells nothing that can have been
   * said is answered so, and nothing is returned.
   *
   * @param agent that has the message; its thread
   */
  public static Optional<Said> of(MaestroAgent agent, Home home, ACLMessage message, Words words) {
    Optional<String> text = words.terms().stream().findFirst().map(Words::plain);
    Optional<String> person = words.string("by");
    boolean isToBeDone =
        message.getPerformative() == ACLMessage.REQUEST
            || message.getPerformative() == ACLMessage.ACCEPT_PROPOSAL;
    if (!isToBeDone || text.filter(said -> !said.isBlank()).isEmpty() || person.isEmpty()) {
      agent.refuse(
          message,
          ACLMessage.NOT_UNDERSTOOD,
          "What is said is told by a request with the words, who speaks, and where, such as"
              + " (say \"turn on the light\" (:by Bob) (:in livingroom)).");
      return Optional.empty();
    }
    Caller caller = caller(agent, home, message, words);
    Utterance utterance =
        new Utterance(
            person.get(),
            words.string("in").orElse(""),
            text.get(),
            caller.user(),
            Optional.empty(),
            words.string("words").filter(name -> isListener(home, name)));
    Optional<String> objection = new UtteranceCheck(home).objection(utterance);
    if (objection.isPresent()) {
      agent.refuse(message, ACLMessage.REFUSE, objection.get());
      return Optional.empty();
    }
    return Optional.of(new Said(message, words, caller, utterance));
  }

  /** A room agent asks in the name of who has told it. */
  private static Caller caller(MaestroAgent agent, Home home, ACLMessage message, Words words) {
    Caller sender = Caller.of(message, agent.getHap());
    return words
        .string("caller")
        .filter(told -> isListener(home, sender.agent()))
        .map(Caller::parse)
        .orElseGet(() -> sender.askingFor(words.string("for")));
  }

  private static boolean isListener(Home home, String agent) {
    Group group = home.groups().get(agent);
    return group != null && group.hearing().isPresent();
  }

  /** The same, understood with the words of a room agent. */
  public Said heardBy(String agent) {
    return new Said(message, words, caller, utterance.heardBy(agent));
  }

  String person() {
    return utterance.person();
  }

  /** In whose name goals are stated by it. */
  String requester() {
    return new Requester(caller.toString(), Optional.of(person())).toString();
  }
}
