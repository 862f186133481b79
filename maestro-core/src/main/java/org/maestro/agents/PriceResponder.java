package org.maestro.agents;

import jade.core.behaviours.Behaviour;
import jade.domain.FIPANames;
import jade.lang.acl.ACLMessage;
import jade.lang.acl.MessageTemplate;
import jade.proto.SSContractNetResponder;
import jade.proto.SSResponderDispatcher;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.members.MemberView;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.sl.Content;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;

/** Answers calls for prices, several at a time, each in a session of its own. */
final class PriceResponder extends SSResponderDispatcher {
  private static final long serialVersionUID = 1L;

  private final transient MaestroAgent agent;
  private final transient MemberView view;

  PriceResponder(MaestroAgent agent, MemberView view) {
    super(
        agent,
        MessageTemplate.and(
            MessageTemplate.MatchProtocol(FIPANames.InteractionProtocol.FIPA_CONTRACT_NET),
            MessageTemplate.MatchPerformative(ACLMessage.CFP)));
    this.agent = agent;
    this.view = view;
  }

  @Override
  protected Behaviour createResponder(ACLMessage cfp) {
    return new Session(cfp);
  }

  private ACLMessage answer(ACLMessage cfp) {
    ACLMessage answer = cfp.createReply();
    answer.setLanguage(MaestroAgent.LANGUAGE);
    try {
      List<Content> prices = prices(cfp);
      if (prices.isEmpty()) {
        String name = agent.getLocalName();
        answer.setPerformative(ACLMessage.REFUSE);
        answer.setContent(
            reason(view.isReady() ? name + " has none of these features" : name + " is not there"));
      } else {
        answer.setPerformative(ACLMessage.PROPOSE);
        answer.setContent(Words.print(prices));
      }
    } catch (SlSyntaxException e) {
      answer.setPerformative(ACLMessage.NOT_UNDERSTOOD);
      answer.setContent(reason(e.getMessage()));
    }
    return answer;
  }

  private static String reason(String sentence) {
    return Words.print(Words.content("inform", Words.named("reason", Words.text(sentence))));
  }

  private List<Content> prices(ACLMessage cfp) {
    List<Content> prices = new ArrayList<>();
    for (Content content : Words.parse(cfp.getContent())) {
      for (Term name : Words.of(content).find("features").map(Words::terms).orElse(List.of())) {
        Optional<FeatureType> feature =
            view.isReady() ? view.feature(Words.plain(name)) : Optional.empty();
        feature.ifPresent(f -> prices.add(price(f)));
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

  /** One call for prices, up to the award. */
  private final class Session extends SSContractNetResponder {
    private static final long serialVersionUID = 1L;

    Session(ACLMessage cfp) {
      super(agent, cfp);
    }

    @Override
    protected ACLMessage handleCfp(ACLMessage cfp) {
      return answer(cfp);
    }

    @Override
    protected ACLMessage handleAcceptProposal(
        ACLMessage cfp, ACLMessage propose, ACLMessage accept) {
      ACLMessage held = accept.createReply();
      held.setPerformative(ACLMessage.INFORM);
      held.setLanguage(MaestroAgent.LANGUAGE);
      held.setContent(
          Words.print(
              Words.content("inform", Words.named("holds", Words.name(agent.getLocalName())))));
      return held;
    }
  }
}
