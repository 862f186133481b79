package org.maestro.rats.protocol;

import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Pattern;

/** The kinds of messages of version 1, each with the topics below a site's root that carry it. */
public enum MessageKind {
  CALL("call(/[^/]+)?"),
  RESULT("result(/[^/]+/[^/]+)?"),
  PROGRESS("progress/[^/]+/[^/]+"),
  STATUS("(member|controller)/[^/]+/status"),
  DESCRIPTION("member/[^/]+/description"),
  STATE("member/[^/]+/state"),
  OBSERVATION("member/[^/]+/observation/[^/]+"),
  STREAM("member/[^/]+/stream/[^/]+"),
  VERDICT("controller/[^/]+/verdict/[^/]+");

  private final Pattern belowRoot;

  MessageKind(String belowRoot) {
    this.belowRoot = Pattern.compile(belowRoot);
  }

  /** The kind that a topic below a site's root carries; empty when it is none of the bus. */
  static Optional<MessageKind> at(String belowRoot) {
    return Arrays.stream(values())
        .filter(kind -> kind.belowRoot.matcher(belowRoot).matches())
        .findFirst();
  }

  /** Whether the latest of it stays with the broker; an empty one withdraws it. */
  public boolean isRetained() {
    return switch (this) {
      case STATUS, DESCRIPTION, STATE, VERDICT -> true;
      case CALL, RESULT, PROGRESS, OBSERVATION, STREAM -> false;
    };
  }
}
