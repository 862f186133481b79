package org.maestro.agents;

import jade.lang.acl.ACLMessage;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.BiFunction;
import org.maestro.knowledge.FeatureRun;
import org.maestro.knowledge.KnowledgeBase;
import org.maestro.knowledge.Source;
import org.maestro.ontology.home.Device;
import org.maestro.sl.Content;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Term;

/**
 * The way to the collective knowledge for agents everywhere (M12, M15): they tell it and ask it in
 * MAESTRO-SL.
 */
public final class KnowledgeAgent extends MaestroAgent {
  private static final long serialVersionUID = 1L;

  public static final String NAME = "knowledge";

  private final transient KnowledgeBase knowledge;
  private final transient BiFunction<String, String, Device> describedBy;

  public KnowledgeAgent(
      AgentTime time, KnowledgeBase knowledge, BiFunction<String, String, Device> describedBy) {
    super(time);
    this.knowledge = knowledge;
    this.describedBy = describedBy;
  }

  @Override
  protected void received(ACLMessage message) {
    for (Content content : Words.parse(message.getContent())) {
      Words words = Words.of(content);
      switch (content.operator()) {
        case "inform" -> informed(message, words);
        case "query-if" -> queryIf(message, content);
        case "query-ref" -> beliefs(message);
        default ->
            refuse(
                message,
                ACLMessage.NOT_UNDERSTOOD,
                "The knowledge agent does not know the operator "
                    + content.operator()
                    + "; it knows inform, query-if and query-ref.");
      }
    }
  }

  private void informed(ACLMessage message, Words words) {
    if (words.string("description").isPresent()) {
      knowledge.describe(
          describedBy.apply(words.string("description").get(), words.string("member").orElse("")));
    } else if (words.find("facts").isPresent()) {
      knowledge.state(
          new Source(Source.Kind.STATED, words.string("source").orElse("unnamed")),
          words.find("facts").get().terms().stream().map(Words::plain).toList());
    } else {
      learn(words);
    }
    if (message.getPerformative() == ACLMessage.REQUEST) {
      reply(
          message,
          ACLMessage.INFORM,
          Words.content("inform", Words.named("done", Words.name("noted"))));
    }
  }

  private void learn(Words words) {
    String member = words.string("member").orElse("");
    String name = words.string("feature").orElse("");
    Map<String, Term> bindings = new TreeMap<>(words.termsOf("bindings"));
    bindings.put("self", new Term.Name(member));
    Optional.ofNullable(knowledge.home().devices().get(member)).stream()
        .flatMap(device -> device.features().stream())
        .filter(feature -> feature.name().equals(name))
        .findFirst()
        .ifPresent(
            feature ->
                knowledge.learn(
                    new FeatureRun(
                        member, feature, bindings, true, words.termsOf("outputs"), List.of())));
  }

  private void queryIf(ACLMessage message, Content content) {
    String truth =
        Words.of(content)
            .formula()
            .map(
                formula ->
                    new Evaluation(knowledge.snapshot())
                        .truth(formula, Map.of())
                        .name()
                        .toLowerCase())
            .orElse("not-a-formula");
    reply(
        message,
        ACLMessage.INFORM,
        Words.content("inform", Words.named("truth", Words.name(truth))));
  }

  private void beliefs(ACLMessage message) {
    reply(
        message,
        ACLMessage.INFORM,
        knowledge.snapshot().beliefs().stream()
            .map(
                belief ->
                    Words.content(
                        "inform",
                        Words.named("fact", Words.text(belief.fact())),
                        Words.named("source", Words.text(belief.source().agent())),
                        Words.named("since", Words.text(belief.since().toString()))))
            .toArray(Content[]::new));
  }
}
