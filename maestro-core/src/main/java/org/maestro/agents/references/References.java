package org.maestro.agents.references;

import jade.core.AID;
import jade.domain.FIPANames;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.pulse.Condition;
import org.maestro.agents.pulse.HeartbeatSettings;
import org.maestro.agents.pulse.Sealed;
import org.maestro.agents.pulse.SessionKey;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Content;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The references that an agent has to others, and those that others have to it, by FIPA's
 * recruiting protocol in one conversation each:
 *
 * <pre>
 * proxy    (refer (:agent lamp-1))                 of the asker to the registry; or (:feature dim)
 * agree    (refer (:agent lamp-1))                 of the registry to the asker; or refuse, and why
 * request  (refer (:asker "tablet"))               of the registry to lamp-1: it passes that on
 * inform   (refer (:agent lamp-1) (:key "..."))    of lamp-1 to the asker
 * request  (beat (:sealed "..."))                  of the asker to lamp-1, as long as both live
 * inform   (beat (:sealed "..."))                  of lamp-1 to the asker
 * </pre>
 *
 * A sign of life carries the asker's key, so that each has the other's. Agent thread only.
 */
public final class References {
  private static final Logger LOG = LoggerFactory.getLogger(References.class);

  /** Wall time; the signs of life of whole processes come oftener, and cost no messages. */
  static final HeartbeatSettings TIMING =
      new HeartbeatSettings(Duration.ofSeconds(2), Duration.ofSeconds(5), Duration.ofSeconds(10));

  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(10);
  private static final String REFER = "refer";
  private static final String BEAT = "beat";
  private static final String SEALED = "sealed";

  private final Post post;
  private final Map<String, Referral> asked = new HashMap<>();
  private final Map<String, Reference> held = new LinkedHashMap<>();
  private final Map<String, Given> given = new LinkedHashMap<>();
  private Clock.Timer timer = () -> {};
  private boolean beating;
  private boolean ended;
  private int number;

  public References(Post post) {
    this.post = post;
  }

  /** Asks for a reference; the holder is told what comes of that. */
  public void ask(Wanted wanted, Holder holder) {
    String id = post.self().getLocalName() + "-refers-" + ++number;
    Clock clock = post.clock();
    Clock.Timer waiting =
        clock.schedule(
            clock.ofWall(ANSWER_WITHIN),
            post.self().getLocalName(),
            () -> post.tell(() -> timedOut(id)));
    asked.put(id, new Referral(holder, waiting));
    send(message(ACLMessage.PROXY, post.registry(), id, wanted.inWords()));
  }

  /**
   * Keeps a reference that is needed all the time: it is asked for again whenever it is lost.
   *
   * @param wanted the first of these that there is; it is looked now and then for one before it
   * @param changed told when there is one, and when there is none any more
   */
  public KeptReference keep(List<Wanted> wanted, Consumer<KeptReference> changed) {
    KeptReference kept = new KeptReference(this, wanted, changed);
    kept.ask();
    return kept;
  }

  /** Does it in a while, if the agent lives then. */
  void later(Duration wallTime, Runnable action) {
    Clock clock = post.clock();
    clock.schedule(
        clock.ofWall(wallTime),
        post.self().getLocalName(),
        () -> post.tell(() -> unlessEnded(action)));
  }

  private void unlessEnded(Runnable action) {
    if (!ended) {
      action.run();
    }
  }

  /** The agents that refer to this one now, by local name. */
  public List<String> holders() {
    return given.values().stream().map(its -> its.holder().getLocalName()).toList();
  }

  /** The holder is told of nothing any more, and the one referred to that it is over. */
  public void drop(Reference reference) {
    if (held.remove(reference.conversation()) != null) {
      send(
          message(
              ACLMessage.CANCEL,
              reference.agent(),
              reference.conversation(),
              Words.content(REFER)));
    }
  }

  /** The agent ends, or leaves its container. */
  public void end() {
    ended = true;
    timer.cancel();
    asked.values().forEach(Referral::end);
    asked.clear();
    held.clear();
    given.clear();
  }

  /** Takes the message if it belongs to a reference; what the registry is asked does not. */
  public boolean takes(ACLMessage message) {
    boolean isMine =
        FIPANames.InteractionProtocol.FIPA_RECRUITING.equals(message.getProtocol())
            && message.getConversationId() != null
            && message.getSender() != null
            && message.getPerformative() != ACLMessage.PROXY;
    if (isMine) {
      try {
        take(message, message.getConversationId());
      } catch (IllegalArgumentException e) {
        LOG.warn(
            "{} hears nothing of a reference in what {} says: {}",
            post.self().getLocalName(),
            Replies.sender(message),
            e.getMessage());
      }
    }
    return isMine;
  }

  private void take(ACLMessage message, String id) {
    Referral referral = asked.get(id);
    Reference reference = held.get(id);
    if (referral != null) {
      answered(message, id, referral);
    } else if (reference != null && message.getPerformative() != ACLMessage.REQUEST) {
      answered(message, reference);
    } else if (message.getPerformative() == ACLMessage.CANCEL) {
      given.remove(key(message.getSender(), id));
    } else if (message.getPerformative() == ACLMessage.REQUEST) {
      Content content = Words.parse(message.getContent()).get(0);
      if (content.operator().equals(REFER)) {
        introduced(message, id);
      } else {
        beaten(message, id, Words.of(content));
      }
    }
  }

  private void answered(ACLMessage message, String id, Referral referral) {
    boolean isFromRegistry =
        message.getSender().equals(post.registry()) || Replies.isFromPlatform(message);
    if (isFromRegistry && message.getPerformative() == ACLMessage.AGREE) {
      String agent = first(message).string("agent").orElse("");
      referral.passedOnTo(agent).ifPresent(early -> answered(early, id, referral));
    } else if (isFromRegistry) {
      refused(id, referral, "%s says: %s".formatted(Replies.sender(message), reason(message)));
    } else if (referral.isFromTheNamed(message)) {
      if (message.getPerformative() == ACLMessage.INFORM) {
        accepted(message, id, referral);
      } else {
        refused(id, referral, reason(message));
      }
    }
  }

  private void accepted(ACLMessage message, String id, Referral referral) {
    SessionKey key = SessionKey.read(first(message).string("key").orElse(""));
    asked.remove(id);
    referral.end();
    Reference reference =
        new Reference(message.getSender(), id, referral.holder(), key, TIMING, now());
    held.put(id, reference);
    send(reference);
    beat();
    referral.holder().referred(reference);
  }

  private void refused(String id, Referral referral, String reason) {
    asked.remove(id);
    referral.end();
    referral.holder().refused(reason);
  }

  private void timedOut(String id) {
    Referral referral = asked.get(id);
    if (referral != null) {
      refused(id, referral, "Nobody has answered within " + Replies.seconds(ANSWER_WITHIN) + ".");
    }
  }

  private void answered(ACLMessage message, Reference reference) {
    if (message.getPerformative() != ACLMessage.INFORM) {
      lose(
          reference,
          Replies.isFromPlatform(message)
              ? "There is no agent %s any more.".formatted(reference.agent().getLocalName())
              : reason(message));
    } else if (!reference.confirmed(sealed(first(message)), now())) {
      LOG.warn(
          "{} does not believe a confirmation of {}: it has not made it, or it was heard before.",
          post.self().getLocalName(),
          reference.agent().getLocalName());
    }
  }

  private void lose(Reference reference, String reason) {
    held.remove(reference.conversation());
    reference.lost(reason);
  }

  private void introduced(ACLMessage message, String id) {
    Iterator<?> askers = message.getAllReplyTo();
    if (!message.getSender().equals(post.registry()) || !askers.hasNext()) {
      refuse(
          message,
          "Nobody refers to %s but through the %s; ask there, by (refer (:agent %s))."
              .formatted(
                  post.self().getLocalName(),
                  post.registry().getLocalName(),
                  post.self().getLocalName()));
      return;
    }
    Given its = new Given((AID) askers.next(), TIMING, now());
    given.put(key(its.holder(), id), its);
    beat();
    reply(
        message,
        ACLMessage.INFORM,
        Words.content(
            REFER,
            Words.named("agent", Words.name(post.self().getLocalName())),
            Words.named("key", Words.text(its.key().write()))));
  }

  /** What somebody else has made is not answered: he may have named the holder as the sender. */
  private void beaten(ACLMessage message, String id, Words words) {
    Given its = given.get(key(message.getSender(), id));
    if (its == null) {
      refuse(
          message,
          "%s knows of no reference of yours, or not any more; ask the %s for one."
              .formatted(post.self().getLocalName(), post.registry().getLocalName()));
      return;
    }
    try {
      Sealed confirmation = its.confirm(sealed(words), now());
      reply(
          message,
          ACLMessage.INFORM,
          Words.content(BEAT, Words.named(SEALED, Words.text(confirmation.write()))));
    } catch (IllegalArgumentException e) {
      LOG.warn(
          "{} does not believe a sign of life of {}: {}.",
          post.self().getLocalName(),
          Replies.sender(message),
          e.getMessage());
    }
  }

  /** From now on signs of life are given and missed, while there is anybody. */
  private void beat() {
    if (!beating && !ended) {
      beating = true;
      Clock clock = post.clock();
      timer =
          clock.schedule(
              clock.ofWall(TIMING.period()),
              post.self().getLocalName(),
              () -> post.tell(this::beaten));
    }
  }

  private void beaten() {
    beating = false;
    if (ended) {
      return;
    }
    Duration now = now();
    for (Reference reference : List.copyOf(held.values())) {
      if (reference.look(now) == Condition.LOST) {
        lose(
            reference,
            "%s has confirmed no sign of life for %s."
                .formatted(reference.agent().getLocalName(), Replies.seconds(TIMING.lostAfter())));
      } else {
        send(reference);
      }
    }
    given.values().removeIf(its -> isSilent(its, now));
    if (!held.isEmpty() || !given.isEmpty()) {
      beat();
    }
  }

  private boolean isSilent(Given its, Duration now) {
    boolean isLost = its.look(now) == Condition.LOST;
    if (isLost) {
      LOG.info(
          "{} has given {} no sign of life for {}: its reference has timed out.",
          its.holder().getLocalName(),
          post.self().getLocalName(),
          Replies.seconds(TIMING.lostAfter()));
    }
    return isLost;
  }

  private void send(Reference reference) {
    send(
        message(
            ACLMessage.REQUEST,
            reference.agent(),
            reference.conversation(),
            Words.content(BEAT, Words.named(SEALED, Words.text(reference.beat().write())))));
  }

  private void send(ACLMessage message) {
    post.send(message);
  }

  private static ACLMessage message(
      int performative, AID receiver, String conversation, Content content) {
    ACLMessage message = new ACLMessage(performative);
    message.addReceiver(receiver);
    message.setLanguage(Words.LANGUAGE);
    message.setOntology(Words.ONTOLOGY);
    message.setProtocol(FIPANames.InteractionProtocol.FIPA_RECRUITING);
    message.setConversationId(conversation);
    message.setContent(Words.print(content));
    return message;
  }

  private void refuse(ACLMessage message, String reason) {
    reply(
        message,
        ACLMessage.REFUSE,
        Words.content("inform", Words.named("reason", Words.text(reason))));
  }

  private void reply(ACLMessage to, int performative, Content content) {
    ACLMessage reply = to.createReply();
    reply.setPerformative(performative);
    reply.setLanguage(Words.LANGUAGE);
    reply.setContent(Words.print(content));
    send(reply);
  }

  private Duration now() {
    return post.clock().toWall(post.clock().now());
  }

  private static Words first(ACLMessage message) {
    return Words.of(Words.parse(message.getContent()).get(0));
  }

  private static Sealed sealed(Words words) {
    return Sealed.read(words.string(SEALED).orElse(""));
  }

  private static String reason(ACLMessage message) {
    return Replies.reason(message).orElse("no reason given");
  }

  private static String key(AID holder, String conversation) {
    return holder.getName() + " " + conversation;
  }
}
