package org.maestro.scenario;

import jade.lang.acl.ACLMessage;
import java.util.Optional;

/** A process with one plain agent that says one message and prints the replies, up to the last. */
final class PlainAgentProcess {

  private PlainAgentProcess() {}

  /**
   * @param arguments port of the main container, message in FIPA's string form
   */
  public static void main(String... arguments) throws Exception {
    PlainAgent.Guest guest =
        PlainAgent.join(
            Optional.empty(), Integer.parseInt(arguments[0]), "other-process", "OtherGuest");
    guest.agent().say(PlainAgent.written(arguments[1]));
    ACLMessage reply;
    do {
      reply = guest.agent().heard();
      System.out.println(
          ACLMessage.getPerformative(reply.getPerformative()) + " " + reply.getContent());
    } while (reply.getPerformative() == ACLMessage.AGREE);
    guest.close();
    System.exit(0);
  }
}
