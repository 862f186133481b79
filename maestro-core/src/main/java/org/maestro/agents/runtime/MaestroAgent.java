package org.maestro.agents.runtime;

import jade.core.AID;
import jade.core.Agent;
import jade.core.ContainerID;
import jade.core.MessageQueue;
import jade.core.ServiceException;
import jade.core.behaviours.Behaviour;
import jade.domain.FIPANames;
import jade.lang.acl.ACLMessage;
import jade.lang.acl.MessageTemplate;
import java.time.Duration;
import java.time.Instant;
import java.util.Date;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.maestro.agents.content.Admission;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.pulse.Pulse;
import org.maestro.agents.pulse.PulseService;
import org.maestro.agents.references.References;
import org.maestro.agents.stepping.SteppedMail;
import org.maestro.agents.stepping.SteppedMailService;
import org.maestro.agents.stepping.TicketedQueue;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Content;
import org.maestro.sl.SlSyntaxException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The base of all MAESTRO agents: messages in MAESTRO-SL, conversations that end, and work handed
 * over from other threads. Behaviours never block. {@link #tell} may be called by any thread,
 * everything else by the agent's own.
 */
public abstract class MaestroAgent extends Agent {
  private static final long serialVersionUID = 1L;
  private static final Logger LOG = LoggerFactory.getLogger(MaestroAgent.class);

  /** Made with the agent, or when JADE, which made it, gives it a place in a container. */
  @SuppressWarnings("NullAway.Init")
  private transient volatile Equipment equipment;

  /** JADE has it made before anything else can reach the agent. */
  @SuppressWarnings("NullAway.Init")
  private transient volatile TicketedQueue queue;

  /** Null when JADE has made it, or brought it from another container. */
  private final transient @Nullable Birth birth;

  private transient volatile boolean forsaken;
  private transient volatile Optional<Pulse> pulse = Optional.empty();

  /**
   * @param birth attested by a container of the platform in which it is to live
   * @throws IllegalStateException when another agent has had that birth
   */
  protected MaestroAgent(Birth birth, AgentTime time) {
    this.birth = Birth.taken(birth);
    equip(time);
  }

  /**
   * Made by JADE: it is equipped by the container in which it begins.
   *
   * @throws IllegalStateException when anybody else makes it
   */
  protected MaestroAgent() {
    Birth.requireMadeByJade(this);
    birth = null;
  }

  private void equip(AgentTime time) {
    pulse = Optional.empty();
    equipment = new Equipment(this, new Own(), time, new Mail()::step);
  }

  /** The time of the container it is in, for one that JADE has made or brought there. */
  protected AgentTime timeHere() {
    throw new IllegalStateException(
        getClass().getSimpleName() + " is not made by its class name, and does not move.");
  }

  /** The first thing that JADE has an agent do in a container. */
  @Override
  protected final MessageQueue createMessageQueue() {
    if (birth != null) {
      birth.requirePlatform(getHap());
    }
    if (equipment == null) {
      equip(timeHere());
    }
    queue = new TicketedQueue(equipment.tickets);
    return queue;
  }

  /** Whether there is a message of the conversation. Any thread may ask. */
  public final boolean hasMailOf(String conversation) {
    return queue.hasAnyOf(conversation);
  }

  @Override
  public void addBehaviour(Behaviour behaviour) {
    if (clock().isStepped()) {
      equipment.idleDetector.added(behaviour);
    }
    super.addBehaviour(behaviour);
  }

  @Override
  public void removeBehaviour(Behaviour behaviour) {
    equipment.idleDetector.removed(behaviour);
    super.removeBehaviour(behaviour);
  }

  /** Waits until the agent has set itself up. Not to be called by an agent. */
  public final boolean awaitStart(Duration limit) throws InterruptedException {
    return equipment.started.await(limit.toMillis(), TimeUnit.MILLISECONDS);
  }

  public final Clock clock() {
    return equipment.time.clock();
  }

  /** How long this agent waits for others. */
  public final ProtocolTimeouts patience() {
    return equipment.time.patience();
  }

  /** So much wall time, as simulated time; on a stepped clock they are the same. */
  public final Duration patience(Duration wallTime) {
    return equipment.time.simulated(wallTime);
  }

  /** What to write into the reply-by slot: the time of other agents is wall time, if any is. */
  public final Date replyBy(Duration wallTime) {
    Instant now =
        clock().isStepped() ? clock().instant() : Instant.ofEpochMilli(System.currentTimeMillis());
    return Date.from(now.plus(wallTime));
  }

  public final Conversations conversations() {
    return equipment.conversations;
  }

  /** The references to others, and of others to this one. Agent thread only. */
  public final References references() {
    return equipment.references;
  }

  @Override
  protected void setup() {
    equipment.tickets.taken(clock().hold("the start of " + getLocalName()));
    equipment.time.mail().ifPresent(this::joinMail);
    if (clock().isStepped()) {
      super.addBehaviour(equipment.idleDetector);
    }
    addBehaviour(equipment.reception);
    if (!clock().isStepped()) {
      pulse = joinPulse();
    }
  }

  /** A container that somebody else has made may have none. */
  private Optional<Pulse> joinPulse() {
    try {
      Pulse its = (Pulse) getHelper(PulseService.NAME);
      its.enlist(getLocalName(), this::tell, () -> forsaken = true, clock());
      return Optional.of(its);
    } catch (ServiceException e) {
      LOG.debug("{} lives in a container without heartbeats", getLocalName(), e);
      return Optional.empty();
    }
  }

  /** The heartbeats of the container; empty on a stepped clock. */
  public final Optional<Pulse> pulse() {
    return pulse;
  }

  /**
   * Has the listener told, once and on the clock's thread, when the platform has given up the
   * container that this agent lives in. Any thread may call.
   */
  public final void whenContainerIsGivenUp(Runnable listener) {
    tell(() -> pulse.ifPresent(its -> its.whenGivenUp(listener)));
  }

  /**
   * Whether another may act in this agent's place, as it hung, or its container has not been heard
   * of for long: nothing may be begun.
   */
  public final boolean isCutOff() {
    return forsaken || pulse.filter(Pulse::isCutOff).isPresent();
  }

  /** Goes to another container; what comes in meanwhile is done there. Agent thread only. */
  public final void goTo(String container) {
    equipment.reception.leave();
    doMove(new ContainerID(container, null));
  }

  /** What is under way here is not taken along. */
  @Override
  protected void beforeMove() {
    removeBehaviour(equipment.reception);
    leave();
  }

  @Override
  protected void afterMove() {
    setup();
  }

  private void joinMail(SteppedMail mail) {
    try {
      ((SteppedMailService.Registration) getHelper(SteppedMailService.NAME)).register(this, mail);
    } catch (ServiceException e) {
      throw new IllegalStateException(
          "A stepped agent needs the service " + SteppedMailService.NAME + " in its container", e);
    }
    mail.open(this, equipment.tickets);
  }

  @Override
  protected void takeDown() {
    // Another has this agent's name: JADE would take that one out at the end of this one.
    while (forsaken) {
      LockSupport.park();
      // JADE interrupts those that are to end, and who was interrupted is not parked.
      Thread.interrupted();
    }
    leave();
  }

  private void leave() {
    equipment.time.mail().ifPresent(mail -> mail.close(this));
    pulse.ifPresent(its -> its.leave(getLocalName()));
    equipment.references.end();
    equipment.inbox.end();
    equipment.tickets.end();
  }

  /** Has the agent do this on its own thread, soon. Any thread may call. */
  public final void tell(Runnable action) {
    equipment.inbox.add(action);
  }

  /** What goes wrong in it goes to the log: JADE ends an agent whose behaviour throws. */
  public final void work(Runnable action) {
    try {
      action.run();
    } catch (RuntimeException e) {
      LOG.error("{} failed at its work", getLocalName(), e);
    }
  }

  /** A message that belongs to no conversation of ours and no contract net. */
  protected abstract void received(ACLMessage message);

  /**
   * @param timeout of wall time on a fast clock: messages do not travel faster on it
   */
  public final void ask(ACLMessage request, Duration timeout, Consumer<ACLMessage> reply) {
    equipment.conversations.ask(request, patience(timeout), reply);
  }

  /** How many behaviours this agent has now, counted on a stepped clock only. */
  public final int behaviourCount() {
    return equipment.idleDetector.behaviourCount();
  }

  public final ACLMessage message(int performative, AID receiver, Content... contents) {
    ACLMessage message = new ACLMessage(performative);
    message.addReceiver(receiver);
    message.setLanguage(Words.LANGUAGE);
    message.setOntology(Words.ONTOLOGY);
    message.setProtocol(FIPANames.InteractionProtocol.FIPA_REQUEST);
    message.setContent(Words.print(contents));
    return message;
  }

  public final void reply(ACLMessage to, int performative, Content... contents) {
    ACLMessage reply = to.createReply();
    reply.setPerformative(performative);
    reply.setLanguage(Words.LANGUAGE);
    reply.setContent(Words.print(contents));
    send(reply);
  }

  /** Says no, with a sentence; a message that is not understood is told so once only. */
  public final void refuse(ACLMessage to, int performative, String sentence) {
    if (performative == ACLMessage.NOT_UNDERSTOOD) {
      equipment.protest.against(to, sentence);
      return;
    }
    reply(to, performative, Words.content("inform", Words.named("reason", Words.text(sentence))));
  }

  /** Whether it hears agents of other platforms; they can name themselves as they like. */
  protected boolean hearsOtherPlatforms() {
    return false;
  }

  /** Whether the sender says that it is of another platform. */
  public final boolean isFromOtherPlatform(ACLMessage message) {
    String name = message.getSender().getName();
    return name.contains("@") && !name.endsWith("@" + getHap());
  }

  /**
   * Whether a behaviour of the agent's own, beside those that all agents have, takes the message.
   */
  protected boolean expects(ACLMessage message) {
    return false;
  }

  /** Whether the message begins a session of its own in a conversation that another has begun. */
  protected boolean opensSession(ACLMessage message) {
    return false;
  }

  /** The behaviour that leads the conversation which the message begins, if one of its own does. */
  protected Optional<Behaviour> session(ACLMessage message) {
    return Optional.empty();
  }

  private final class Own implements OwnThread {
    @Override
    public void tell(Runnable action) {
      MaestroAgent.this.tell(action);
    }

    @Override
    public void work(Runnable action) {
      MaestroAgent.this.work(action);
    }

    @Override
    public void wake() {
      equipment.reception.restart();
    }
  }

  /** Messages that are neither replies to our requests nor part of a contract net under way. */
  private final class Mail {
    private final MessageTemplate template =
        new MessageTemplate(
            m -> (opensSession(m) || !equipment.conversations.isOurs(m)) && !expects(m));

    boolean step() {
      ACLMessage message = receive(template);
      if (message != null && !equipment.references.takes(message)) {
        sort(message);
      }
      return message != null;
    }

    private void sort(ACLMessage message) {
      if (message.getSender() == null || message.getSender().getName() == null) {
        equipment.protest.drop(message, "it has no sender who could be answered");
      } else if (Replies.isFromPlatform(message) || isFromYellowPages(message)) {
        equipment.protest.drop(message, "a receipt that nobody waits for");
      } else if (message.getPerformative() == ACLMessage.NOT_UNDERSTOOD) {
        equipment.protest.drop(
            message, Replies.reason(message).orElse("it did not understand something"));
      } else if (isContractNet(message) && message.getPerformative() != ACLMessage.CFP) {
        equipment.protest.drop(message, "its contract net is over");
      } else {
        Optional<Behaviour> session =
            isFromOtherPlatform(message) ? Optional.empty() : session(message);
        session.ifPresentOrElse(MaestroAgent.this::addBehaviour, () -> admit(message));
      }
    }

    private void admit(ACLMessage message) {
      Optional<String> objection =
          isFromOtherPlatform(message) && !hearsOtherPlatforms()
              ? Optional.of(
                  "%s talks to agents of its own platform only; ask %s."
                      .formatted(getLocalName(), AgentNames.COORDINATOR))
              : Admission.objection(message);
      if (objection.isPresent()) {
        equipment.protest.against(message, objection.get());
      } else {
        handle(message);
      }
    }

    private boolean isContractNet(ACLMessage message) {
      return FIPANames.InteractionProtocol.FIPA_CONTRACT_NET.equals(message.getProtocol());
    }

    private boolean isFromYellowPages(ACLMessage message) {
      AID sender = message.getSender();
      return sender.getName().startsWith(FIPANames.DEFAULT_DF) && sender.equals(getDefaultDF());
    }

    private void handle(ACLMessage message) {
      try {
        received(message);
      } catch (SlSyntaxException | KnowledgeException e) {
        equipment.protest.against(
            message, Objects.requireNonNullElse(e.getMessage(), e.toString()));
      } catch (RuntimeException e) {
        LOG.error(
            "{} could not handle {}",
            getLocalName(),
            Replies.shortened(String.valueOf(message.getContent())),
            e);
        refuse(
            message,
            ACLMessage.FAILURE,
            getLocalName() + " could not handle the message; its log says why.");
      }
    }
  }
}
