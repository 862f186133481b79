/**
 * Conversations with persons of the home, whichever way their words come: what somebody says flows
 * in, and what is to be done about it flows out as a {@link org.maestro.dialogue.Reading}. Each
 * person has one conversation, in which it is remembered what was spoken of and asked back (ADE,
 * 4.2; A65). It does nothing of it, and knows neither agents nor pages.
 */
@NullMarked
package org.maestro.dialogue;

import org.jspecify.annotations.NullMarked;
