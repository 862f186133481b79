package org.maestro.knowledge.api;

import java.util.Optional;

/**
 * A step between the messages of its member, in the order in which the member sent them.
 *
 * @param begun what was heard until then was said before the step
 * @param ended when its result was heard: what is heard later includes what the step did
 * @param last what the member had said of itself last when its result was heard
 * @param includesStep whether the member itself says that this was after the step's end
 */
public record StepAccount(
    Moment begun, Moment ended, Optional<MemberWord> last, boolean includesStep) {

  /** The message that tells of the step's end: the result, or what was said knowing of it. */
  public Moment tellsOfTheEnd() {
    return last.filter(word -> includesStep).map(MemberWord::moment).orElse(ended);
  }

  /** The same, where nobody knows what was said before the step began: it began in another life. */
  public StepAccount begunLongAgo() {
    return new StepAccount(new Moment(begun.listener(), 0), ended, last, includesStep);
  }
}
