package org.maestro.agents.device;

import jade.core.behaviours.Behaviour;
import jade.domain.FIPANames;
import jade.lang.acl.ACLMessage;
import jade.lang.acl.MessageTemplate;
import jade.proto.SSContractNetResponder;
import jade.proto.states.MsgReceiver;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.maestro.agents.content.Admission;
import org.maestro.agents.content.ProposalReader;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.BatchingBehaviour;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.members.MemberView;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Content;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Answers calls for prices, several at a time, each in a session of its own. It is no behaviour, as
 * JADE would wake it for every message.
 */
public final class PriceResponder {
  private static final Logger LOG = LoggerFactory.getLogger(PriceResponder.class);

  private final MaestroAgent agent;
  private final Function<Words, Optional<MemberView>> viewOf;
  private final Access access;
  private final Optional<String> mark;
  private final Map<String, Integer> sessionsByConversation = new HashMap<>();
  private int unnamed;
  private int offers;

  /** The access policy: who may ask for what. */
  public interface Access {
    /** Everybody for everything. */
    Access OPEN = (message, words, feature) -> Optional.empty();

    /** Why not, in a part of a sentence. */
    Optional<String> objection(ACLMessage message, Words words, String feature);
  }

  /**
   * @param viewOf the member of which a call speaks
   * @param mark put into each offer, so that several of one conversation are told apart; empty
   *     where there is one at most
   */
  public PriceResponder(
      MaestroAgent agent,
      Function<Words, Optional<MemberView>> viewOf,
      Access access,
      Optional<String> mark) {
    this.agent = agent;
    this.viewOf = viewOf;
    this.access = access;
    this.mark = mark;
  }

  /** Whether an offer is open that may be taken up. */
  public boolean isIdle() {
    return sessionsByConversation.isEmpty();
  }

  /** The session that the message begins; empty when it is no call for prices. */
  public Optional<Behaviour> session(ACLMessage message) {
    if (message.getPerformative() != ACLMessage.CFP
        || !FIPANames.InteractionProtocol.FIPA_CONTRACT_NET.equals(message.getProtocol())) {
      return Optional.empty();
    }
    if (message.getConversationId() == null) {
      message.setConversationId(agent.getLocalName() + "-call-" + ++unnamed);
    }
    return Optional.of(
        new BatchingBehaviour(
            new Session(message), () -> agent.hasMailOf(message.getConversationId())));
  }

  private ACLMessage answer(ACLMessage cfp) {
    ACLMessage answer = cfp.createReply();
    answer.setLanguage(Words.LANGUAGE);
    answer.setOntology(Words.ONTOLOGY);
    Optional<String> objection = Admission.objection(cfp);
    if (objection.isPresent()) {
      answer.setPerformative(ACLMessage.NOT_UNDERSTOOD);
      answer.setContent(reason(objection.get()));
      return answer;
    }
    try {
      List<String> objections = new ArrayList<>();
      List<Content> prices = prices(cfp, objections::add);
      if (prices.isEmpty()) {
        answer.setPerformative(ACLMessage.REFUSE);
        answer.setContent(reason(objections.isEmpty() ? nothingToOffer(cfp) : objections.get(0)));
      } else {
        answer.setPerformative(ACLMessage.PROPOSE);
        answer.setReplyByDate(agent.replyBy(agent.patience().offer()));
        mark.ifPresent(name -> answer.setReplyWith(name + "-offer-" + ++offers));
        answer.setContent(Words.print(prices));
      }
    } catch (SlSyntaxException e) {
      answer.setPerformative(ACLMessage.NOT_UNDERSTOOD);
      answer.setContent(reason(Objects.requireNonNullElse(e.getMessage(), e.toString())));
    }
    return answer;
  }

  private String nothingToOffer(ACLMessage cfp) {
    return agent.getLocalName() + (isReady(cfp) ? " has none of these features" : " is not there");
  }

  private static String reason(String sentence) {
    return Words.print(Words.content("inform", Words.named("reason", Words.text(sentence))));
  }

  private boolean isReady(ACLMessage cfp) {
    return Words.parse(cfp.getContent()).stream()
        .flatMap(content -> viewOf.apply(Words.of(content)).stream())
        .anyMatch(MemberView::isReady);
  }

  private List<Content> prices(ACLMessage cfp, Consumer<String> objections) {
    List<Content> prices = new ArrayList<>();
    for (Content content : Words.parse(cfp.getContent())) {
      Words words = Words.of(content);
      Optional<MemberView> view = viewOf.apply(words).filter(MemberView::isReady);
      for (Term name : words.find("features").map(Words::terms).orElse(List.of())) {
        Optional<FeatureType> feature = view.flatMap(v -> v.feature(Words.plain(name)));
        feature.ifPresent(
            f ->
                access
                    .objection(cfp, words, f.name())
                    .ifPresentOrElse(objections, () -> prices.add(price(f))));
      }
    }
    return prices;
  }

  private static Content price(FeatureType feature) {
    Content.Argument price =
        feature.cost() instanceof Price.Stated stated
            ? Words.named("stated", Words.text(SlPrinter.print(stated.cost())))
            : Words.named(
                "at-least", Words.text(SlPrinter.print(((Price.Asked) feature.cost()).atLeast())));
    return Words.content("cost", Words.named("feature", Words.name(feature.name())), price);
  }

  /**
   * One call for prices, up to the award. The contract is that the agent holds itself ready for its
   * part at the prices it named; the steps themselves are ordered one by one. An offer that nobody
   * takes up or rejects ends by the clock.
   */
  private final class Session extends SSContractNetResponder {
    private static final long serialVersionUID = 1L;
    private final String conversation;
    private transient Clock.Timer timer = () -> {};

    Session(ACLMessage cfp) {
      super(agent, cfp);
      conversation = cfp.getConversationId();
      registerTransition(RECEIVE_NEXT, HANDLE_REJECT_PROPOSAL, MsgReceiver.INTERRUPTED);
      sessionsByConversation.merge(conversation, 1, Integer::sum);
      agent.conversations().adopt(conversation);
    }

    @Override
    protected ACLMessage handleCfp(ACLMessage cfp) {
      return answer(cfp);
    }

    @Override
    protected void afterReply(ACLMessage reply) {
      super.afterReply(reply);
      MsgReceiver next = (MsgReceiver) getState(RECEIVE_NEXT);
      next.setDeadline(MsgReceiver.INFINITE);
      if (reply != null && reply.getReplyWith() != null) {
        next.setTemplate(
            MessageTemplate.and(
                MessageTemplate.MatchConversationId(conversation),
                MessageTemplate.MatchInReplyTo(reply.getReplyWith())));
      }
      if (reply != null && reply.getPerformative() == ACLMessage.PROPOSE) {
        timer =
            agent
                .clock()
                .schedule(
                    agent.patience(agent.patience().offer()),
                    agent.getLocalName(),
                    () -> agent.tell(next::interrupt));
      }
    }

    @Override
    protected ACLMessage handleAcceptProposal(
        ACLMessage cfp, ACLMessage propose, ACLMessage accept) {
      ACLMessage word = accept.createReply();
      word.setLanguage(Words.LANGUAGE);
      word.setOntology(Words.ONTOLOGY);
      Optional<String> obstacle = obstacle(cfp, accept);
      word.setPerformative(obstacle.isPresent() ? ACLMessage.FAILURE : ACLMessage.INFORM);
      word.setContent(
          obstacle
              .map(PriceResponder::reason)
              .orElseGet(
                  () ->
                      Words.print(
                          Words.content(
                              "inform", Words.named("holds", Words.name(agent.getLocalName()))))));
      return word;
    }

    @Override
    protected void handleOutOfSequence(ACLMessage cfp, ACLMessage propose, ACLMessage message) {
      LOG.warn(
          "{} sent {} {} in the middle of a contract net; ignored",
          Replies.sender(message),
          agent.getLocalName(),
          ProposalReader.performative(message));
    }

    @Override
    public int onEnd() {
      timer.cancel();
      sessionsByConversation.computeIfPresent(
          conversation, (id, open) -> open > 1 ? open - 1 : null);
      if (!sessionsByConversation.containsKey(conversation)) {
        agent.conversations().leave(conversation);
      }
      return super.onEnd();
    }
  }

  /** Why the agent cannot hold the part it is awarded, though it has proposed to. */
  private Optional<String> obstacle(ACLMessage cfp, ACLMessage accept) {
    try {
      Optional<MemberView> view =
          Words.parse(cfp.getContent()).stream()
              .flatMap(content -> viewOf.apply(Words.of(content)).stream())
              .findFirst()
              .filter(MemberView::isReady);
      if (view.isEmpty()) {
        return Optional.of(agent.getLocalName() + " is not there any more");
      }
      return Words.parse(accept.getContent()).stream()
          .map(content -> Words.of(content).string("feature").orElse("without a name"))
          .filter(name -> view.get().feature(name).isEmpty())
          .map(name -> agent.getLocalName() + " has no feature " + name)
          .findFirst();
    } catch (SlSyntaxException e) {
      return Optional.of("the award cannot be read: " + e.getMessage());
    }
  }
}
