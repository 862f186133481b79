package org.maestro.console.questions;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.agents.DeskAgent;
import org.maestro.agents.content.Orders;
import org.maestro.agents.content.Words;
import org.maestro.coordination.api.Argument;
import org.maestro.sl.Content;
import org.maestro.sl.Term;

/**
 * Orders to the agents of members, by hand and for no goal: the agents judge them as they judge any
 * other. Any thread may order, and nothing blocks.
 */
public final class AclCalls {
  private final DeskAgent desk;

  public AclCalls(DeskAgent desk) {
    this.desk = desk;
  }

  /**
   * Is told of one order, on the desk's thread: of its refusal, or that it is agreed to and how it
   * ends.
   */
  public interface Listener {
    void agreed();

    void refused(RefusalException because);

    void done(Map<String, Term> outputs);

    void failed(String reason);
  }

  /**
   * Has a member do something.
   *
   * @param agent that stands for the member
   * @param timeout simulated time that it may take
   * @param person who has signed in at the desk, and for whom it asks
   * @param patience the same until its agent has to have told how it ended
   * @return calls it off; how it ended is told all the same
   */
  public Runnable call(
      String agent,
      String member,
      String feature,
      Map<String, Term> parameters,
      Optional<String> person,
      Duration timeout,
      Duration patience,
      Listener listener) {
    boolean[] agreed = {false};
    return desk.order(
        agent,
        patience,
        reply -> {
          if (reply.getPerformative() == ACLMessage.AGREE) {
            agreed[0] = true;
            listener.agreed();
          } else if (DeskAgent.isEnd(reply)) {
            end(reply, agreed[0], listener);
          }
        },
        order(agent, member, feature, parameters, person, timeout));
  }

  private static void end(ACLMessage reply, boolean wasAgreed, Listener listener) {
    List<Words> words = Reply.words(reply);
    if (reply.getPerformative() == ACLMessage.INFORM) {
      Map<String, Term> outputs = new LinkedHashMap<>();
      words.forEach(line -> outputs.putAll(line.termsOf("outputs")));
      listener.done(outputs);
    } else if (wasAgreed) {
      listener.failed(Reply.reason(words));
    } else {
      listener.refused(
          reply.getPerformative() == ACLMessage.FAILURE
              ? RefusalException.outside(Reply.reason(words))
              : Reply.refusal(words));
    }
  }

  private static Content order(
      String agent,
      String member,
      String feature,
      Map<String, Term> parameters,
      Optional<String> person,
      Duration timeout) {
    Map<String, Argument> named = new TreeMap<>();
    parameters.forEach(
        (name, value) -> named.put(name, new Argument(value, Optional.empty(), Map.of())));
    return Orders.byHand(member, agent, feature, named, person, timeout);
  }
}
