package org.maestro.agents.content;

import jade.lang.acl.ACLMessage;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.coordination.api.Proposal;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.sl.Content;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** Reads one member's answer to a call for prices; what is no price is left out, and said. */
public final class ProposalReader {
  /** In cost units, which are seconds plus weighted energy: some thirty years. */
  static final double HIGHEST_PRICE = 1e9;

  private static final Facts NOTHING_KNOWN =
      new Facts() {
        @Override
        public Truth truth(Formula.Atom atom) {
          return Truth.UNKNOWN;
        }

        @Override
        public OptionalDouble number(Expression.Fluent fluent) {
          return OptionalDouble.empty();
        }

        @Override
        public Collection<Term.Name> individuals(String className) {
          return List.of();
        }
      };

  private final String member;
  private final List<String> asked;
  private final List<String> faults = new ArrayList<>();

  public ProposalReader(String member, List<String> asked) {
    this.member = member;
    this.asked = asked;
  }

  /** Sentences about the answer read last, the member's name first. */
  public List<String> faults() {
    return List.copyOf(faults);
  }

  public Proposal read(ACLMessage answer) {
    faults.clear();
    try {
      return switch (answer.getPerformative()) {
        case ACLMessage.PROPOSE -> proposal(Words.parse(answer.getContent()));
        case ACLMessage.REFUSE -> refusal(reason(answer).orElse("refused without a reason"));
        case ACLMessage.NOT_UNDERSTOOD ->
            fault(
                "did not understand the call for prices"
                    + reason(answer).map(r -> ": " + r).orElse(""));
        case ACLMessage.FAILURE ->
            fault(Replies.isFromPlatform(answer) ? "has no agent any more" : failure(answer));
        default -> fault("answered the call for prices with " + performative(answer));
      };
    } catch (SlSyntaxException e) {
      return fault(
          "answered the call for prices unreadably: "
              + Replies.shortened(Objects.requireNonNullElse(e.getMessage(), e.toString())));
    }
  }

  private static String failure(ACLMessage answer) {
    return "failed at the call for prices" + reason(answer).map(r -> ": " + r).orElse("");
  }

  public static String performative(ACLMessage answer) {
    return ACLMessage.getPerformative(answer.getPerformative()).toLowerCase(Locale.ROOT);
  }

  private static Optional<String> reason(ACLMessage answer) {
    return Replies.reason(answer).map(Replies::shortened);
  }

  private Proposal proposal(List<Content> contents) {
    Map<String, Price> prices = new LinkedHashMap<>();
    for (Content content : contents) {
      Words words = Words.of(content);
      Optional<String> feature = words.string("feature");
      if (feature.isEmpty()) {
        note("named a price without a feature");
      } else if (!asked.contains(feature.get())) {
        note("priced " + Replies.shortened(feature.get()) + ", which was not asked");
      } else if (prices.containsKey(feature.get())) {
        note("priced " + feature.get() + " twice; the first price counts");
      } else {
        price(feature.get(), words).ifPresent(price -> prices.put(feature.get(), price));
      }
    }
    if (prices.isEmpty()) {
      return refusal(faults.isEmpty() ? "proposed no price" : withoutName(faults.get(0)));
    }
    return new Proposal(member, prices, Optional.empty());
  }

  private Optional<Price> price(String feature, Words words) {
    Optional<String> stated = words.string("stated");
    Optional<String> atLeast = words.string("at-least");
    String text = stated.or(() -> atLeast).orElse("nothing");
    try {
      Expression cost = SlParser.expression(text);
      if (isSound(cost)) {
        return Optional.of(stated.isPresent() ? new Price.Stated(cost) : new Price.Asked(cost));
      }
    } catch (SlSyntaxException e) {
      // The note below says what was asked instead of a price.
    }
    note("asks " + Replies.shortened(text) + " for " + feature + ", which is no price");
    return Optional.empty();
  }

  /** A formula over facts or parameters is sound until its value is known. */
  private static boolean isSound(Expression cost) {
    if (cost instanceof Expression.OfTerm single && !isNumber(single)) {
      return single.term() instanceof Term.Variable;
    }
    if (!isConstant(cost)) {
      return true;
    }
    OptionalDouble value = new Evaluation(NOTHING_KNOWN).number(cost, Map.of());
    return value.isPresent() && isPrice(value.getAsDouble());
  }

  private static boolean isConstant(Expression cost) {
    return cost instanceof Expression.Arithmetic arithmetic
        ? arithmetic.operands().stream().allMatch(ProposalReader::isConstant)
        : cost instanceof Expression.OfTerm single && isNumber(single);
  }

  private static boolean isNumber(Expression.OfTerm single) {
    return single.term() instanceof Term.Number;
  }

  public static boolean isPrice(double value) {
    return value >= 0 && value <= HIGHEST_PRICE;
  }

  private Proposal fault(String what) {
    note(what);
    return refusal(what);
  }

  private Proposal refusal(String reason) {
    return new Proposal(member, Map.of(), Optional.of(reason));
  }

  private void note(String what) {
    faults.add(member + " " + what);
  }

  private String withoutName(String sentence) {
    return sentence.substring(member.length() + 1);
  }
}
