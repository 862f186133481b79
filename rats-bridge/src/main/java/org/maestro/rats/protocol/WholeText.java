package org.maestro.rats.protocol;

/**
 * Text of whole characters only. JSON can write half of one (a surrogate without the other), and
 * who cuts a text may make one; UTF-8 cannot hold it.
 */
final class WholeText {

  private static final String REPLACEMENT = "\uFFFD";

  private WholeText() {}

  static boolean isWhole(String text) {
    for (int index = 0; index < text.length(); index++) {
      if (Character.isSurrogate(text.charAt(index))) {
        if (!isPair(text, index)) {
          return false;
        }
        index++;
      }
    }
    return true;
  }

  /** With the sign for what cannot be shown in place of each half character. */
  static String mended(String text) {
    if (isWhole(text)) {
      return text;
    }
    StringBuilder mended = new StringBuilder();
    for (int index = 0; index < text.length(); index++) {
      if (!Character.isSurrogate(text.charAt(index))) {
        mended.append(text.charAt(index));
      } else if (isPair(text, index)) {
        mended.append(text, index, index + 2);
        index++;
      } else {
        mended.append(REPLACEMENT);
      }
    }
    return mended.toString();
  }

  /** Mended, and at most so many characters with three dots after them. */
  static String shortened(String text, int most) {
    String mended = mended(text);
    if (mended.length() <= most) {
      return mended;
    }
    int end = Character.isHighSurrogate(mended.charAt(most - 1)) ? most - 1 : most;
    return mended.substring(0, end) + "...";
  }

  private static boolean isPair(String text, int index) {
    return Character.isHighSurrogate(text.charAt(index))
        && index + 1 < text.length()
        && Character.isLowSurrogate(text.charAt(index + 1));
  }
}
