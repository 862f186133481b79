package org.maestro.coordination.story;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.maestro.coordination.api.Proposal;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.sl.Expression;
import org.maestro.sl.SlPrinter;

/** Says of bids who asks what; of the same ones once more only that they are the same. */
final class ProposalSentences {
  private String last = "";

  String of(List<Proposal> bids, int notCalled, int questions, List<String> unpriced) {
    String told = told(bids, notCalled);
    String prices =
        (questions == 0 ? "" : " Exact prices asked: " + questions + ".")
            + (unpriced.isEmpty() ? "" : " Not priced: " + String.join("; ", unpriced) + ".");
    String sentences =
        (told.equals(last) ? "The bids are the same as before" : told) + "." + prices;
    last = told;
    return sentences;
  }

  private static String told(List<Proposal> bids, int notCalled) {
    List<String> offers =
        bids.stream()
            .filter(bid -> bid.refusal().isEmpty())
            .map(bid -> bid.member() + " " + prices(bid.prices()))
            .toList();
    List<String> refusals =
        bids.stream()
            .filter(bid -> bid.refusal().isPresent())
            .map(bid -> bid.member() + " (" + bid.refusal().get() + ")")
            .toList();
    return (offers.isEmpty() ? "Nobody bids" : "Bids: " + String.join("; ", offers))
        + (refusals.isEmpty() ? "" : ". Refused: " + String.join("; ", refusals))
        + (notCalled == 0 ? "" : ". " + notCalled + " others describe higher prices");
  }

  private static String prices(Map<String, Price> prices) {
    return prices.entrySet().stream()
        .map(e -> e.getKey() + " " + price(e.getValue()))
        .collect(Collectors.joining(", "));
  }

  private static String price(Price price) {
    if (price instanceof Price.Stated stated) {
      return amount(stated.cost());
    }
    return "at least " + amount(((Price.Asked) price).atLeast());
  }

  private static String amount(Expression cost) {
    return cost instanceof Expression.OfTerm ? SlPrinter.print(cost) : "by formula";
  }
}
