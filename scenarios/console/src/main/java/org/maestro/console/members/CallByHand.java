package org.maestro.console.members;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.maestro.console.documents.JsonMembers;
import org.maestro.sl.Term;

/**
 * A call that somebody makes of a member's feature, and what has become of it.
 *
 * @param id here, such as M1
 * @param outcome in a sentence's words; empty while it is under way
 */
record CallByHand(
    String id,
    String member,
    String feature,
    Map<String, Term> parameters,
    State state,
    Optional<String> outcome) {

  enum State {
    UNDER_WAY,
    DONE,
    FAILED;

    String word() {
      return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
  }

  CallByHand ended(State as, String told) {
    return new CallByHand(id, member, feature, parameters, as, Optional.of(told));
  }

  JsonNode document() {
    return JsonMembers.empty()
        .text("id", id)
        .text("member", member)
        .text("feature", feature)
        .terms("parameters", parameters)
        .text("state", state.word())
        .text("outcome", outcome)
        .node();
  }
}
