/**
 * What people say, understood word by word in a situation (ADE, 4.2; A9 to A13, A59 to A67). A
 * home, a grammar and words flow in; MAESTRO-SL messages, questions back and the reasons of both
 * flow out. Knows neither agents nor goals: who carries a message out is not its business.
 */
@NullMarked
package org.maestro.language;

import org.jspecify.annotations.NullMarked;
