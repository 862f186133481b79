package org.maestro.agents.negotiation;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.maestro.agents.content.ProposalReader;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.Conversations;
import org.maestro.coordination.api.ContractNet.Quote;
import org.maestro.sl.Content;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;

/** Reads one member's answer to a question for exact prices of a feature. */
final class QuoteReader {
  private final String member;
  private final String feature;
  private final int asked;
  private final List<String> faults = new ArrayList<>();

  QuoteReader(String member, String feature, int asked) {
    this.member = member;
    this.feature = feature;
    this.asked = asked;
  }

  /** Sentences about the answer, the member's name first. */
  List<String> faults() {
    return List.copyOf(faults);
  }

  /** As many quotes as were asked, whatever the answer is. */
  List<Quote> read(ACLMessage reply, Duration patience) {
    if (Conversations.isOverdue(reply)) {
      return unanswered(
          "did not say within " + Replies.seconds(patience) + " what " + feature + " would cost");
    }
    if (Replies.isFromPlatform(reply)) {
      return unanswered("has no agent any more to say what " + feature + " would cost");
    }
    String reason = Replies.reason(reply).map(Replies::shortened).orElse("no reason given");
    return switch (reply.getPerformative()) {
      case ACLMessage.INFORM -> informed(reply);
      case ACLMessage.REFUSE -> declined(reason);
      default ->
          unanswered(
              "answered what "
                  + feature
                  + " would cost with "
                  + ProposalReader.performative(reply)
                  + ": "
                  + reason);
    };
  }

  private List<Quote> informed(ACLMessage reply) {
    List<Content> contents;
    try {
      contents = Words.parse(reply.getContent());
    } catch (SlSyntaxException e) {
      return unanswered(
          "said unreadably what "
              + feature
              + " would cost: "
              + Replies.shortened(Objects.requireNonNullElse(e.getMessage(), e.toString())));
    }
    if (contents.size() != asked) {
      return unanswered(
          "named "
              + contents.size()
              + " prices for "
              + feature
              + " where "
              + asked
              + " were asked");
    }
    return contents.stream().map(Words::of).map(this::quote).toList();
  }

  private Quote quote(Words words) {
    Optional<Words> price = words.find("price");
    if (price.isPresent()) {
      return priced(price.get().terms());
    }
    Optional<String> silence = words.string("unanswered").map(Replies::shortened);
    return silence.isPresent()
        ? new Quote.Unanswered(silence.get())
        : new Quote.Declined(
            words
                .string("reason")
                .or(() -> words.string("problem"))
                .map(Replies::shortened)
                .orElse("no price given"));
  }

  private Quote priced(List<Term> numbers) {
    if (numbers.size() == 2
        && numbers.get(0) instanceof Term.Number cost
        && numbers.get(1) instanceof Term.Number seconds
        && ProposalReader.isPrice(cost.value())
        && ProposalReader.isPrice(seconds.value())) {
      return new Quote.Priced(cost.value(), seconds.value());
    }
    String fault =
        "asks "
            + Replies.shortened(inWords(numbers.stream().map(Words::plain).toList()))
            + " for "
            + feature
            + ", which is no price";
    faults.add(member + " " + fault);
    return new Quote.Declined(fault);
  }

  private static String inWords(List<String> numbers) {
    return numbers.size() == 2
        ? numbers.get(0) + " and " + numbers.get(1) + " s"
        : String.join(" ", numbers);
  }

  private List<Quote> declined(String reason) {
    return Collections.nCopies(asked, new Quote.Declined(reason));
  }

  private List<Quote> unanswered(String what) {
    faults.add(member + " " + what);
    return unanswered(asked, what);
  }

  /** As many answers as were asked for, of one who did not give any. */
  static List<Quote> unanswered(int sets, String reason) {
    return Collections.nCopies(sets, new Quote.Unanswered(reason));
  }
}
