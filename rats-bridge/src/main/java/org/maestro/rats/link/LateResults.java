package org.maestro.rats.link;

import java.util.Map;
import java.util.Optional;
import org.maestro.rats.bounded.BoundedMap;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.Result;

/**
 * Results of calls that were ended here without a word of their members: kept for who asks again by
 * the same id. Clock thread only.
 */
final class LateResults {
  private static final int MOST_EXPECTED = 256;

  private final Map<String, Expected> expected = BoundedMap.ofNewest(MOST_EXPECTED);

  private record Expected(Call call, Optional<Result> result) {}

  /** The call was ended, and its member may still say what came of it. */
  void expect(Call call) {
    expected.put(call.id(), new Expected(call, Optional.empty()));
  }

  void heard(String sender, Result result) {
    expected.computeIfPresent(
        result.id(),
        (id, late) ->
            late.call.member().filter(sender::equals).isPresent()
                ? new Expected(late.call, Optional.of(result))
                : late);
  }

  /** What came of the call, which is made again in the same words; it is not kept any longer. */
  Optional<Result> of(Call again) {
    return Optional.ofNullable(expected.remove(again.id()))
        .filter(former -> former.call.isAgain(again))
        .flatMap(Expected::result);
  }
}
