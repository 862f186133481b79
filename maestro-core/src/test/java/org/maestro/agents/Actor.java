package org.maestro.agents;

import jade.core.AID;
import jade.core.behaviours.CyclicBehaviour;
import jade.lang.acl.ACLMessage;
import jade.lang.acl.MessageTemplate;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.ProposalReader;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;

/** A JADE agent in the place of a member's generic agent, which behaves as its part wants. */
public final class Actor extends MaestroAgent {
  private static final long serialVersionUID = 1L;

  /** What the actor does with each kind of message; by itself everything is done right. */
  public interface Part {
    default double price() {
      return 1;
    }

    default void called(Actor actor, ACLMessage cfp) {
      actor.propose(cfp, String.valueOf(price()));
    }

    default void accepted(Actor actor, ACLMessage accept) {
      actor.answer(accept, ACLMessage.INFORM, "(inform (:holds me))");
    }

    default void asked(Actor actor, ACLMessage question) {
      actor.answer(question, ACLMessage.INFORM, "(cost (:price %s 1))".formatted(price()));
    }

    default void ordered(Actor actor, ACLMessage order) {
      actor.answer(order, ACLMessage.AGREE, "(perform)");
      actor.later(Duration.ofSeconds(1), () -> actor.done(order));
    }

    default void subscribed(Actor actor, ACLMessage subscription) {}

    default void cancelled(Actor actor, ACLMessage cancel) {}

    /** All is done right, at this price. */
    static Part at(double price) {
      return new Part() {
        @Override
        public double price() {
          return price;
        }
      };
    }

    /** Called for prices, it does this instead. */
    static Part onCall(BiConsumer<Actor, ACLMessage> deed) {
      return new Part() {
        @Override
        public void called(Actor actor, ACLMessage cfp) {
          deed.accept(actor, cfp);
        }
      };
    }

    /** Its proposal accepted, it does this instead. */
    static Part onAccept(BiConsumer<Actor, ACLMessage> deed) {
      return new Part() {
        @Override
        public void accepted(Actor actor, ACLMessage accept) {
          deed.accept(actor, accept);
        }
      };
    }

    /** Asked for exact prices, it does this instead. */
    static Part onQuestion(BiConsumer<Actor, ACLMessage> deed) {
      return new Part() {
        @Override
        public void asked(Actor actor, ACLMessage question) {
          deed.accept(actor, question);
        }
      };
    }

    /** Ordered to do a step, it does this instead. */
    static Part onOrder(BiConsumer<Actor, ACLMessage> deed) {
      return new Part() {
        @Override
        public void ordered(Actor actor, ACLMessage order) {
          deed.accept(actor, order);
        }
      };
    }
  }

  private final transient Part part;
  private final transient List<String> heard = new ArrayList<>();

  Actor(Birth birth, AgentTime time, Part part) {
    super(birth, time);
    this.part = part;
  }

  @Override
  protected void setup() {
    super.setup();
    addBehaviour(
        new CyclicBehaviour(this) {
          private static final long serialVersionUID = 1L;

          @Override
          public void action() {
            ACLMessage message = receive(new MessageTemplate(Actor.this::expects));
            if (message == null) {
              block();
            } else {
              heard(message);
            }
          }
        });
    announce("ready");
  }

  void announce(String phase) {
    send(
        message(
            ACLMessage.INFORM,
            getAID(AgentNames.COORDINATOR),
            Words.content(
                "inform",
                Words.named("member", Words.name(getLocalName())),
                Words.named("phase", Words.name(phase)))));
  }

  @Override
  protected boolean expects(ACLMessage message) {
    return !Replies.isFromPlatform(message);
  }

  @Override
  protected void received(ACLMessage message) {
    throw new IllegalStateException("Nothing is left for here: " + message);
  }

  private void heard(ACLMessage message) {
    if (saysNothingOfItself(message)) {
      return;
    }
    synchronized (heard) {
      heard.add(ProposalReader.performative(message));
    }
    switch (message.getPerformative()) {
      case ACLMessage.CFP -> part.called(this, message);
      case ACLMessage.ACCEPT_PROPOSAL -> part.accepted(this, message);
      case ACLMessage.SUBSCRIBE -> part.subscribed(this, message);
      case ACLMessage.CANCEL -> part.cancelled(this, message);
      case ACLMessage.REQUEST -> {
        if (message.getContent().startsWith("(cost")) {
          part.asked(this, message);
        } else {
          part.ordered(this, message);
        }
      }
      default -> {
        // A rejection, or not-understood: nothing to do.
      }
    }
  }

  private boolean saysNothingOfItself(ACLMessage message) {
    boolean isAsked =
        message.getPerformative() == ACLMessage.REQUEST
            && message.getContent().startsWith("(describe");
    if (isAsked) {
      answer(message, ACLMessage.INFORM, "(inform (:done described))");
    }
    return isAsked;
  }

  /** Performatives of all messages that came, in order, but for questions what it is like. */
  List<String> heard() {
    synchronized (heard) {
      return List.copyOf(heard);
    }
  }

  void propose(ACLMessage cfp, String price) {
    String kind = cfp.getContent().contains("guide") ? "at-least" : "stated";
    String feature = cfp.getContent().contains("guide") ? "guide" : "greet";
    answer(
        cfp,
        ACLMessage.PROPOSE,
        "(cost (:feature %s) (:%s \"%s\"))".formatted(feature, kind, price));
  }

  void done(ACLMessage order) {
    answer(order, ACLMessage.INFORM, "(inform (:outputs))");
  }

  /** Says it to another of the platform; what is answered is heard as all else is. */
  void ask(String agent, int performative, String content) {
    ACLMessage request = new ACLMessage(performative);
    request.addReceiver(getAID(agent));
    request.setConversationId(getLocalName() + "-asks");
    request.setContent(content);
    tell(() -> send(request));
  }

  void answer(ACLMessage message, int performative, String content) {
    ACLMessage answer = message.createReply();
    answer.setPerformative(performative);
    answer.setContent(content);
    send(answer);
  }

  void later(Duration delay, Runnable deed) {
    clock().schedule(delay, getLocalName(), () -> tell(deed));
  }

  AID cca() {
    return getAID(AgentNames.COORDINATOR);
  }
}
